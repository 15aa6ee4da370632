#include "meshalyzer/picture/internal/scene_lines.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/picture/internal/contact_segments.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

namespace meshalyzer {
namespace {

constexpr std::size_t kFloatsOfSegment = 6;

/// Returns one half-edge for each edge.
std::vector<HalfedgeHandle> first_halfedges(const CutEdges& edges) {
  std::vector<HalfedgeHandle> halfedges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    halfedges.push_back(edges[i].halfedges.front());
  }
  return halfedges;
}

/// Draws the lines of one mesh, kind by kind.
class LineDrawing {
 public:
  LineDrawing(const PreparedMesh& mesh, const DrawingFrame& frame, std::size_t max)
      : mesh_(mesh), frame_(frame), max_(max) {}

  /// @param kind  The kind of the edges in the plural.
  std::vector<float> edges(const std::vector<HalfedgeHandle>& halfedges, std::string_view kind) {
    const std::size_t n = std::min(halfedges.size(), max_);
    if (n < halfedges.size()) {
      notes_.push_back(fmt::format("Of {} {} the first {} are drawn as lines.",
                                   grouped(halfedges.size()), kind, grouped(n)));
    }
    std::vector<float> segments;
    segments.reserve(kFloatsOfSegment * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (const Index v : file_ends(mesh_.cut(), halfedges[i])) {
        append_point(segments, frame_(mesh_.soup().positions[v]));
      }
    }
    return segments;
  }

  std::vector<float> contacts(const std::vector<IntersectingPair>& pairs) {
    // Each pair has at least one segment, so this many pairs are enough.
    const std::size_t n = std::min(pairs.size(), max_);
    const auto parts = map_chunks<std::vector<float>>(n, [&](Chunk chunk) {
      std::vector<float> segments;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) append_contact(pairs[i], segments);
      return segments;
    });
    std::vector<float> all;
    for (const std::vector<float>& part : parts) all.insert(all.end(), part.begin(), part.end());
    const bool is_cut = n < pairs.size() || all.size() > kFloatsOfSegment * max_;
    all.resize(std::min(all.size(), kFloatsOfSegment * max_));
    if (is_cut) {
      notes_.push_back(fmt::format("Of {} the first {} along which they meet are drawn.",
                                   counted(pairs.size(), "intersecting pair", "intersecting pairs"),
                                   counted(all.size() / kFloatsOfSegment, "line", "lines")));
    }
    return all;
  }

  [[nodiscard]] std::vector<std::string> take_notes() { return std::move(notes_); }

 private:
  void append_contact(const IntersectingPair& pair, std::vector<float>& segments) const {
    const Soup& soup = mesh_.soup();
    for (const auto& [from, to] : contact_segments(corners_of(soup, pair.face_a),
                                                   corners_of(soup, pair.face_b), pair.kind)) {
      append_point(segments, frame_(from));
      append_point(segments, frame_(to));
    }
  }

  const PreparedMesh& mesh_;
  const DrawingFrame& frame_;
  std::size_t max_;
  std::vector<std::string> notes_;
};

}  // namespace

DrawnLines draw_lines(const PreparedMesh& mesh, const DrawingFrame& frame, std::size_t max) {
  LineDrawing drawing(mesh, frame, max);
  const SideTable& side = mesh.cut().side;
  DrawnLines drawn;
  drawn.lines.borders = drawing.edges(find_border_edges(mesh.cut()), "border edges");
  drawn.lines.non_manifold_edges =
      drawing.edges(first_halfedges(side.non_manifold_edges), "non-manifold edges");
  drawn.lines.flipped_edges = drawing.edges(first_halfedges(side.flipped_edges), "flipped edges");
  drawn.lines.intersections = drawing.contacts(mesh.intersecting_pairs());
  drawn.notes = drawing.take_notes();
  return drawn;
}

}  // namespace meshalyzer
