#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/items_by_group.h"
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
  /// The sign is 1 if the face has the orientation of the piece, -1 if it has the opposite one.
  Sign sign = 1;

  friend bool operator==(const PieceSource&, const PieceSource&) = default;
};

/// The exact positions of the vertices of an arrangement. It is cheap to copy.
class ExactVertices {
 public:
  ExactVertices() = default;
  /// @param made  The positions of the new vertices.
  explicit ExactVertices(std::vector<ExactPoint> made);

  /// Returns the position of vertex n_input_vertices + i.
  [[nodiscard]] const ExactPoint& made(std::size_t i) const;

 private:
  std::shared_ptr<const std::vector<ExactPoint>> made_;
};

/// A soup cut along its self-intersections into triangles that meet only in vertices and edges
/// which they have in common by index. It is exact: its vertices are fractions; their doubles only
/// approximate them.
///
/// A face that intersects nothing is a piece itself. Any other is the union of its pieces; where
/// coplanar faces overlap, a piece occurs once and lists its faces. A face of no area has pieces
/// only where edges would not match without them, and a face outside the complex has none.
struct Arrangement {
  /// Vertices of lower index are the input's.
  std::size_t n_input_vertices = 0;
  /// #vertices: the input's, then the nearest doubles of the new points, in lexicographic order of
  /// their exact positions. Different vertices of pieces have different positions, except those of
  /// faces of no area that meet nothing; but different positions may have the same nearest doubles.
  std::vector<Vec3> positions;
  ExactVertices exact;

  /// #pieces, in order of the lowest face of each, which determines the orientation.
  std::vector<Triangle> pieces;
  /// #pieces + 1: where the sources of each begin in `sources`, ascending by face.
  std::vector<Index> source_begin{0};
  std::vector<PieceSource> sources;
  /// #faces: the pieces of each, ascending.
  ItemsByGroup pieces_of_faces;

  /// The faces that intersect others, whether they had to be cut or not, ascending.
  std::vector<Index> cut_faces;
  /// The edges of pieces along which intersecting faces meet, each with its lower vertex first,
  /// ascending.
  std::vector<std::array<Index, 2>> curves;

  [[nodiscard]] std::span<const PieceSource> sources_of(std::size_t piece) const {
    return std::span(sources).subspan(source_begin[piece],
                                      source_begin[piece + 1] - source_begin[piece]);
  }
  [[nodiscard]] std::span<const Index> pieces_of(Index face) const { return pieces_of_faces[face]; }
  /// Returns the nearest doubles of the corners of a piece.
  [[nodiscard]] Corners corners_of(std::size_t piece) const {
    return meshalyzer::corners_of(positions, pieces[piece]);
  }
  /// Returns how often the faces cover a piece; faces of opposite orientation count negative.
  [[nodiscard]] int multiplicity(std::size_t piece) const;
};

}  // namespace meshalyzer
