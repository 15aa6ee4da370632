#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace meshalyzer {

/// The faces of the complex that use each of some vertices of a file.
class VertexStars {
 public:
  /// @param vertices  Ascending, each once.
  /// @complexity      O(log #copies + n log n) a vertex of n faces.
  VertexStars(const CutMesh& cut, std::vector<Index> vertices);

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] Index vertex(std::size_t star) const { return vertices_[star]; }
  /// By index in the file, ascending.
  [[nodiscard]] std::span<const Index> faces(std::size_t star) const {
    return std::span(faces_).subspan(begin_[star], begin_[star + 1] - begin_[star]);
  }

  /// The star of one of the vertices.
  [[nodiscard]] std::size_t star_of(Index vertex) const;
  /// Where the faces of a star begin in a list of those of all stars.
  [[nodiscard]] std::size_t begin(std::size_t star) const { return begin_[star]; }
  /// Where a face of a star stands in it.
  [[nodiscard]] std::size_t place(std::size_t star, Index face) const;
  /// How many faces all stars have, each counted once for every star it is in.
  [[nodiscard]] std::size_t n_places() const { return faces_.size(); }

 private:
  std::vector<Index> vertices_;
  std::vector<std::size_t> begin_{0};
  std::vector<Index> faces_;
};

/// A side of a face that ends at the vertex of its star.
struct Spoke {
  /// The vertex at its other end.
  Index other = 0;
  /// The face's place in the star.
  Index place = 0;
};

/// The faces of a star by edge: two spokes a face, ascending by their other ends, then by face.
/// Those with the same other end are an edge of the complex.
[[nodiscard]] std::vector<Spoke> find_spokes(const Soup& soup, const VertexStars& stars,
                                             std::size_t star);

/// Says how faces are joined across an edge with more than two: called with its spokes, it gives
/// for each the number of that which it is joined to among them, kNoIndex for none.
using JoinWideEdge = std::function<std::vector<Index>(std::span<const Spoke>)>;

/// Finds the fans of a star: faces joined through edges with two faces, whichever way they are
/// oriented, and as is said through those with more.
///
/// @return  By place in the star: the number of the fan, from 0 in order of their lowest faces.
[[nodiscard]] std::vector<Index> find_fans_of_star(const Soup& soup, const VertexStars& stars,
                                                   std::size_t star, const JoinWideEdge& join);

}  // namespace meshalyzer
