#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/contour/bisection_grid.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A part of space.
class Region {
 public:
  virtual ~Region() = default;
  Region() = default;
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;

  /// Tells whether a point belongs to it. Called from several threads.
  [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;

  /// Where a segment leaves the region, as a share of its length. Called from several threads.
  ///
  /// @param inside   A point that belongs to the region.
  /// @param outside  One that does not.
  [[nodiscard]] virtual double crossing(const Vec3& inside, const Vec3& outside) const = 0;
};

/// Tells which vertices of a grid lie in a region.
struct GridLabels {
  /// The vertices of the grid, packed(); ascending.
  std::vector<std::uint64_t> vertices;
  /// #vertices: 1 for those in the region.
  std::vector<std::uint8_t> inside;
};

/// Finds which vertices of tetrahedra lie in a region. Vertices on the faces of the grid's cube
/// never do.
///
/// @param leaves  Numbers of tetrahedra, as BisectionGrid::leaves() returns them.
/// @param known   Labels found before, of the same region: nothing is asked again.
/// @complexity    O(#tetrahedra log #tetrahedra), and one question for each new vertex.
[[nodiscard]] GridLabels label_vertices(const BisectionGrid& grid, const std::vector<Index>& leaves,
                                        const Region& region, const GridLabels& known = {});

/// A surface between the vertices that lie in a region and those that do not.
struct Contour {
  std::vector<Vec3> positions;
  /// Their normals point out of the region.
  std::vector<Triangle> triangles;
  /// #triangles: the number of the tetrahedron in which each lies.
  std::vector<Index> leaves;
};

/// Draws the surface that separates the labels of a grid's vertices (marching tetrahedra: Doi and
/// Koide 1991, "An efficient method of triangulating equi-valued surfaces").
///
/// Whatever the labels and the region are, the surface is closed, manifold, consistently oriented
/// outwards, and free of self-intersections, exactly: its vertices lie on edges of the grid, no
/// nearer to an end than 8/256 of the edge, at whole multiples of 1/256 of it, which doubles hold
/// without rounding; so each triangle lies in its own tetrahedron and is no segment. It is empty
/// where all labels are equal.
///
/// @param labels  As label_vertices() returns them, or any others that are 0 on the faces of the
/// cube.
/// @complexity    O(#tetrahedra log #tetrahedra), and one Region::crossing() for each vertex of the
/// contour.
[[nodiscard]] Contour march_tetrahedra(const BisectionGrid& grid, const std::vector<Index>& leaves,
                                       const GridLabels& labels, const Region& region);

}  // namespace meshalyzer
