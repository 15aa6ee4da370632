#include "meshalyzer/arrangement/remove_slivers.h"

#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// No more steps are made than this multiple of the number of faces that were thin at first, nor
/// once these have become this multiple of faces: where very many have an edge in common, each step
/// divides them all.
constexpr std::size_t kStepsPerSliver = 16;
constexpr std::size_t kMostGrowth = 2;

/// The thin feature of a face.
struct ThinPart {
  /// The corner at which its edge begins: the shortest edge, or the longest if the altitude on it
  /// is low.
  std::size_t edge = 0;
  bool is_short_edge = false;
};

std::optional<ThinPart> thin_part_of(const RoundedFaces& faces, Index face, double width) {
  const Corners corners = corners_of(faces.positions, faces.triangles[face]);
  const auto lengths = side_lengths(corners);
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  if (*shortest < width) {
    return ThinPart{static_cast<std::size_t>(shortest - lengths.begin()), true};
  }
  if (normal_of(corners).norm() >= width * *longest) return std::nullopt;
  return ThinPart{static_cast<std::size_t>(longest - lengths.begin()), false};
}

std::vector<Index> find_slivers(const RoundedFaces& faces, double width) {
  std::vector<Index> slivers;
  for (Index face = 0; face < faces.triangles.size(); ++face) {
    if (faces.ages[face] == FaceAge::Old) continue;
    if (thin_part_of(faces, face, width)) slivers.push_back(face);
  }
  return slivers;
}

/// Removes thin faces one by one, and those that become thin by it.
class SliverRemoval {
 public:
  SliverRemoval(RoundedFaces& faces, double width)
      : faces_(faces), width_(width), edits_(faces), is_kept_(faces.positions.size(), 0) {}

  /// @param pending  The thin faces.
  void run(std::vector<Index> pending) {
    std::size_t n_steps_left = kStepsPerSliver * pending.size();
    const std::size_t most_faces = faces_.triangles.size() + (kMostGrowth - 1) * pending.size();
    while (!pending.empty()) {
      for (const Index face : std::exchange(pending, {})) {
        if (n_steps_left == 0 || faces_.triangles.size() > most_faces) break;
        if (edits_.is_removed(face)) continue;
        const std::optional<ThinPart> part = thin_part_of(faces_, face, width_);
        if (!part) continue;
        --n_steps_left;
        remove(Triangle(faces_.triangles[face]), *part);
      }
      pending = edits_.take_changed();
    }
    edits_.finish();
  }

 private:
  void remove(const Triangle& t, const ThinPart& part) {
    const Index a = t[part.edge];
    const Index b = t[(part.edge + 1) % 3];
    if (part.is_short_edge) {
      collapse(std::min(a, b), std::max(a, b));
    } else {
      edits_.split_edge(a, b, t[(part.edge + 2) % 3]);
    }
  }

  /// Collapses an edge, if it can be done without moving a vertex to which others have moved.
  void collapse(Index low, Index high) {
    if (is_kept_[low] != 0 && is_kept_[high] != 0) return;
    const Index into = is_kept_[high] != 0 ? high : low;
    is_kept_[into] = 1;
    edits_.collapse(into == low ? high : low, into);
  }

  RoundedFaces& faces_;
  double width_;
  RoundedFaceEdits edits_;
  /// #positions: 1 for the vertices to which others have moved. They stay, so that no vertex moves
  /// farther than the width, however many close ones are in a row.
  std::vector<std::uint8_t> is_kept_;
};

}  // namespace

bool has_slivers(const RoundedFaces& faces, double width) {
  return !find_slivers(faces, width).empty();
}

void remove_slivers(RoundedFaces& faces, double width) {
  std::vector<Index> slivers = find_slivers(faces, width);
  if (!slivers.empty()) SliverRemoval(faces, width).run(std::move(slivers));
}

}  // namespace meshalyzer
