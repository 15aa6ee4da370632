#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/contour/bisection_grid.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A region of space.
class Region {
 public:
  virtual ~Region() = default;
  Region() = default;
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;

  /// Tells whether a point belongs to the region. It is called from several threads.
  [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;

  /// Tells whether exactly one of two points belongs to the region. It is called from several
  /// threads.
  [[nodiscard]] virtual bool contains_one_of(const Vec3& first, const Vec3& second) const {
    return contains(first) != contains(second);
  }

  /// Returns where a segment leaves the region, as a share of its length. It is called from several
  /// threads.
  ///
  /// @param inside   A point that belongs to the region.
  /// @param outside  A point that does not.
  [[nodiscard]] virtual double crossing(const Vec3& inside, const Vec3& outside) const = 0;
};

/// The labels of the vertices of a grid: inside a region or not.
struct GridLabels {
  /// The vertices of the grid as numbers made by packed(), ascending.
  std::vector<std::uint64_t> vertices;
  /// #vertices: 1 for those in the region.
  std::vector<std::uint8_t> inside;
};

/// Finds which vertices of tetrahedra lie in a region. Vertices on the faces of the grid's cube
/// always count as outside.
///
/// @param leaves  The numbers of tetrahedra that BisectionGrid::leaves() returns.
/// @param known   Labels of the same region found before, which are reused.
/// @complexity    O(#tetrahedra log #tetrahedra), and one Region::contains() for each new vertex.
[[nodiscard]] GridLabels label_vertices(const BisectionGrid& grid, const std::vector<Index>& leaves,
                                        const Region& region, const GridLabels& known = {});

/// A surface between the vertices that lie in a region and those that do not.
struct Contour {
  std::vector<Vec3> positions;
  /// The triangles, whose normals point out of the region.
  std::vector<Triangle> triangles;
  /// #triangles: the number of the tetrahedron in which each lies.
  std::vector<Index> leaves;
};

/// Extracts the surface that separates the labels of a grid's vertices (marching tetrahedra: Doi
/// and Koide 1991, "An efficient method of triangulating equi-valued surfaces").
///
/// For any labels and region the surface is exactly closed, manifold, consistently oriented
/// outwards, and free of self-intersections: its vertices lie on edges of the grid, no nearer to an
/// end than 8/256 of the edge, at whole multiples of 1/256 of it, which are exact in double
/// precision; so each triangle lies in its own tetrahedron and has an area. The surface is empty if
/// all labels are equal.
///
/// @param labels  The result of label_vertices(), or any other labels that are 0 on the faces of
///                the cube.
/// @complexity    O(#tetrahedra log #tetrahedra), and one Region::crossing() for each vertex of the
/// contour.
[[nodiscard]] Contour march_tetrahedra(const BisectionGrid& grid, const std::vector<Index>& leaves,
                                       const GridLabels& labels, const Region& region);

}  // namespace meshalyzer
