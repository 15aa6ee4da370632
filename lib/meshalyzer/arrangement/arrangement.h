#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/exact/predicates.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace meshalyzer {

struct ExactPoint;

/// A face of the input that covers a piece.
struct PieceSource {
  Index face = kNoIndex;
  /// 1 where the face has the orientation of the piece, -1 where it has the opposite.
  Sign sign = 1;

  friend bool operator==(const PieceSource&, const PieceSource&) = default;
};

/// The exact places of the vertices of an arrangement. Cheap to copy.
class ExactVertices {
 public:
  ExactVertices() = default;
  /// @param made  Of the vertices that are none of the input's.
  explicit ExactVertices(std::vector<ExactPoint> made);

  /// The place of vertex n_input_vertices + i.
  [[nodiscard]] const ExactPoint& made(std::size_t i) const;

 private:
  std::shared_ptr<const std::vector<ExactPoint>> made_;
};

/// A soup cut along its self-intersections, into triangles that meet in nothing but vertices and
/// edges which they have in common by index. Exact: its vertices are known as fractions, and only
/// for a look at them as doubles.
///
/// Faces that intersect nothing are pieces as they are. A face that does is the union of its
/// pieces; where faces of one plane overlap, a piece comes once and says which faces it is of.
/// Faces of no area have pieces only where without them edges would not fit, and faces that are in
/// no complex have none.
struct Arrangement {
  /// Vertices of lower index are the input's.
  std::size_t n_input_vertices = 0;
  /// #vertices: the input's, then the points that were made, by their nearest doubles, in
  /// lexicographic order of their exact places. Different vertices of pieces are at different
  /// places, but for those of faces of no area that meet nothing; these places may have the same
  /// doubles nearest to them.
  std::vector<Vec3> positions;
  ExactVertices exact;

  /// #pieces, in order of the lowest face of each, which gives the orientation.
  std::vector<Triangle> pieces;
  /// #pieces + 1: where the sources of each begin in `sources`, ascending by face.
  std::vector<Index> source_begin{0};
  std::vector<PieceSource> sources;
  /// #faces + 1: where the pieces of each face begin in `piece_of`, ascending.
  std::vector<Index> piece_begin{0};
  std::vector<Index> piece_of;

  /// The faces that were cut, or could have been: those that intersect others. Ascending.
  std::vector<Index> cut_faces;
  /// Edges of pieces along which faces meet that have more in common than the edge by id, each with
  /// its lower vertex first. Ascending.
  std::vector<std::array<Index, 2>> curves;

  [[nodiscard]] std::span<const PieceSource> sources_of(std::size_t piece) const {
    return std::span(sources).subspan(source_begin[piece],
                                      source_begin[piece + 1] - source_begin[piece]);
  }
  [[nodiscard]] std::span<const Index> pieces_of(Index face) const {
    return std::span(piece_of).subspan(piece_begin[face],
                                       piece_begin[face + 1] - piece_begin[face]);
  }
  /// Returns the corners of a piece, by their nearest doubles.
  [[nodiscard]] Corners corners_of(std::size_t piece) const {
    const auto& [a, b, c] = pieces[piece];
    return {positions[a], positions[b], positions[c]};
  }
  /// Returns how often the faces cover a piece, those of its orientation counted positive, the
  /// others negative.
  [[nodiscard]] int multiplicity(std::size_t piece) const;
};

}  // namespace meshalyzer
