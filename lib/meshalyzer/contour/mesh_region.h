#pragma once

#include "meshalyzer/contour/march_tetrahedra.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/winding_number.h"

namespace meshalyzer {

/// The solid that a mesh represents, even if the mesh is open, intersects itself or has doubled
/// walls: the points whose winding number is at least one half in magnitude (Jacobson et al. 2013,
/// "Robust inside-outside segmentation using generalized winding numbers").
///
/// The region is an estimate: algorithms that use it must be correct for any answers.
class MeshRegion : public Region {
 public:
  /// @param soup  The mesh, whose faces in the complex are the surface.
  /// @param tree  The tree over these faces, which must outlive this object.
  MeshRegion(const Soup& soup, const FaceTree& tree);

  [[nodiscard]] bool contains(const Vec3& point) const override;

  [[nodiscard]] bool contains_one_of(const Vec3& first, const Vec3& second) const override;

  /// Tells whether the boundary of the region may lie at a point although the mesh has no face
  /// there. The winding numbers of a closed mesh are whole, so a hole must be spanned where the
  /// number lies midway between whole ones.
  [[nodiscard]] bool spans_hole_at(const Vec3& point) const;

  /// Returns the point where the segment meets the surface, or if there are several the first that
  /// leads out of the region. If the surface has a hole there, it is the point where contains()
  /// changes.
  [[nodiscard]] double crossing(const Vec3& inside, const Vec3& outside) const override;

 private:
  [[nodiscard]] double crossing_by_bisection(const Vec3& inside, const Vec3& outside) const;

  const FaceTree& tree_;
  WindingNumbers winding_;
};

}  // namespace meshalyzer
