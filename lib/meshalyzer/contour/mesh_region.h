#pragma once

#include "meshalyzer/contour/march_tetrahedra.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/winding_number.h"

namespace meshalyzer {

/// The solid that a mesh means, also where the mesh is open, cuts itself or has doubled walls: the
/// points that its surface goes round at least half a time, either way (Jacobson et al. 2013,
/// "Robust inside-outside segmentation using generalized winding numbers").
///
/// An estimate: what is built on it must hold for any answers.
class MeshRegion : public Region {
 public:
  /// @param soup  Its faces in the complex are the surface.
  /// @param tree  Over these faces; must outlive this.
  MeshRegion(const Soup& soup, const FaceTree& tree);

  [[nodiscard]] bool contains(const Vec3& point) const override;

  /// Tells whether the boundary of the region may lie at a point although the mesh has no face
  /// there: a closed mesh goes round every point a whole number of times, so there is a hole to be
  /// spanned where the number lies midway between whole ones.
  [[nodiscard]] bool spans_hole_at(const Vec3& point) const;

  /// Where the surface is met between the two points, or, where it is met several times, the first
  /// time that leads out of the region; where it has a hole there, where contains() changes.
  [[nodiscard]] double crossing(const Vec3& inside, const Vec3& outside) const override;

 private:
  [[nodiscard]] double crossing_by_bisection(const Vec3& inside, const Vec3& outside) const;

  const FaceTree& tree_;
  WindingNumbers winding_;
};

}  // namespace meshalyzer
