#include "meshalyzer/repair/split/cut_stars.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace meshalyzer {
namespace {

/// A corner of a face that gets another vertex.
struct NewCorner {
  Index face = 0;
  Index star = 0;
  /// The fan beyond the first.
  Index fan = 0;
};

/// In order of their faces, then of their stars.
std::vector<NewCorner> find_new_corners(const VertexStars& stars, std::span<const Index> fans) {
  std::vector<NewCorner> corners;
  for (Index star = 0; star < stars.size(); ++star) {
    const auto faces = stars.faces(star);
    for (std::size_t place = 0; place < faces.size(); ++place) {
      const Index fan = fans[stars.begin(star) + place];
      if (fan != 0) corners.push_back({.face = faces[place], .star = star, .fan = fan});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const NewCorner& a, const NewCorner& b) {
    return std::tie(a.face, a.star) < std::tie(b.face, b.star);
  });
  return corners;
}

/// Writes the edits of stars whose operations are known.
class StarCutter {
 public:
  StarCutter(const Soup& soup, const VertexStars& stars) : soup_(soup), stars_(stars) {}

  /// Adds the copies of the vertex of each star, those of a set of stars in its operation.
  void add_copies(std::span<const Index> fans, DisjointSets& together) {
    operation_.assign(stars_.size(), kNoIndex);
    first_copy_.assign(stars_.size(), 0);
    for (Index star = 0; star < stars_.size(); ++star) {
      const auto first = fans.begin() + static_cast<std::ptrdiff_t>(stars_.begin(star));
      const auto n = static_cast<std::ptrdiff_t>(stars_.faces(star).size());
      const Index n_copies = n == 0 ? 0 : *std::max_element(first, first + n);
      if (n_copies == 0) continue;
      Index& operation = operation_[together.find(star)];
      if (operation == kNoIndex) operation = edits_.begin_operation();
      operation_[star] = operation;
      first_copy_[star] = static_cast<Index>(soup_.n_vertices() + edits_.added_vertices.size());
      const Index v = stars_.vertex(star);
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
      const Index copy = first_copy_[corner.star] + corner.fan - 1;
      std::replace(triangle.begin(), triangle.end(), stars_.vertex(corner.star), copy);
    }
    edits_.changed_faces.push_back(
        {.op = operation_[corners.front().star], .face = face, .corners = triangle});
  }

  [[nodiscard]] Edits take() { return std::move(edits_); }

 private:
  const Soup& soup_;
  const VertexStars& stars_;
  std::vector<Index> operation_;
  /// By star: the name of its first copy.
  std::vector<Index> first_copy_;
  Edits edits_;
};

}  // namespace

Edits cut_stars(const Soup& soup, const VertexStars& stars, std::span<const Index> fans,
                DisjointSets together) {
  const std::vector<NewCorner> corners = find_new_corners(stars, fans);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].face == corners[i - 1].face) {
      together.unite(corners[i].star, corners[i - 1].star);
    }
  }
  StarCutter cutter(soup, stars);
  cutter.add_copies(fans, together);
  const std::span<const NewCorner> all(corners);
  for (std::size_t first = 0; first < all.size();) {
    std::size_t last = first + 1;
    while (last < all.size() && all[last].face == all[first].face) ++last;
    cutter.change_face(all.subspan(first, last - first));
    first = last;
  }
  return cutter.take();
}

}  // namespace meshalyzer
