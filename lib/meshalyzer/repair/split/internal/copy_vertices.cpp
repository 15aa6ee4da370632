#include "meshalyzer/repair/split/internal/copy_vertices.h"

#include "meshalyzer/base/runs.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

namespace meshalyzer {
namespace {

/// Copies of a vertex for more fans than these touch in more than a hundred thousand pairs.
constexpr Index kMostFans = 500;

/// A corner of a face that gets another vertex.
struct NewCorner {
  Index face = 0;
  Index entry = 0;
  /// The number of the fan, not counting the first.
  Index fan = 0;
};

/// Returns the corners in order of their faces, then of their entries.
std::vector<NewCorner> find_new_corners(const IncidentFaces& incident,
                                        std::span<const Index> fans) {
  std::vector<NewCorner> corners;
  for (Index entry = 0; entry < incident.size(); ++entry) {
    const auto faces = incident.faces(entry);
    for (std::size_t place = 0; place < faces.size(); ++place) {
      const Index fan = fans[incident.begin(entry) + place];
      if (fan != 0) corners.push_back({.face = faces[place], .entry = entry, .fan = fan});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const NewCorner& a, const NewCorner& b) {
    return std::tie(a.face, a.entry) < std::tie(b.face, b.entry);
  });
  return corners;
}

/// Writes the edits of vertices whose operations are known.
class VertexCopier {
 public:
  VertexCopier(const Soup& soup, const IncidentFaces& incident)
      : soup_(soup), incident_(incident) {}

  /// Adds the copies of each vertex; the vertices of a set share one operation.
  void add_copies(std::span<const Index> fans, DisjointSets& together) {
    operation_.assign(incident_.size(), kNoIndex);
    first_copy_.assign(incident_.size(), 0);
    for (Index entry = 0; entry < incident_.size(); ++entry) {
      const auto first = fans.begin() + static_cast<std::ptrdiff_t>(incident_.begin(entry));
      const auto n = static_cast<std::ptrdiff_t>(incident_.faces(entry).size());
      const Index n_copies = n == 0 ? 0 : *std::max_element(first, first + n);
      if (n_copies == 0) continue;
      Index& operation = operation_[together.find(entry)];
      if (operation == kNoIndex) operation = edits_.begin_operation();
      operation_[entry] = operation;
      first_copy_[entry] = static_cast<Index>(soup_.n_vertices() + edits_.added_vertices.size());
      const Index v = incident_.vertex(entry);
      for (Index copy = 0; copy < n_copies; ++copy) {
        edits_.added_vertices.push_back(
            {.op = operation, .position = soup_.positions[v], .copy_of = v});
      }
    }
  }

  /// Gives a face all its new corners.
  void change_face(std::span<const NewCorner> corners) {
    const Index face = corners.front().face;
    Triangle triangle = soup_.triangles[face];
    for (const NewCorner& corner : corners) {
      const Index copy = first_copy_[corner.entry] + corner.fan - 1;
      std::replace(triangle.begin(), triangle.end(), incident_.vertex(corner.entry), copy);
    }
    edits_.changed_faces.push_back(
        {.op = operation_[corners.front().entry], .face = face, .corners = triangle});
  }

  [[nodiscard]] Edits take() { return std::move(edits_); }

 private:
  const Soup& soup_;
  const IncidentFaces& incident_;
  std::vector<Index> operation_;
  /// The number of the first copy of each entry's vertex.
  std::vector<Index> first_copy_;
  Edits edits_;
};

}  // namespace

bool are_too_many_fans(std::span<const Index> fans) {
  // They are numbered from 0.
  return std::any_of(fans.begin(), fans.end(), [](Index fan) { return fan >= kMostFans; });
}

Edits copy_vertices(const Soup& soup, const IncidentFaces& incident, std::span<const Index> fans,
                    DisjointSets together) {
  const std::vector<NewCorner> corners = find_new_corners(incident, fans);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].face == corners[i - 1].face) {
      together.unite(corners[i].entry, corners[i - 1].entry);
    }
  }
  VertexCopier cutter(soup, incident);
  cutter.add_copies(fans, together);
  for_each_run(std::span(corners), &NewCorner::face,
               [&](std::span<const NewCorner> of_face) { cutter.change_face(of_face); });
  return cutter.take();
}

}  // namespace meshalyzer
