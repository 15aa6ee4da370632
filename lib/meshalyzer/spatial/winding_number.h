#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <memory>
#include <vector>

namespace meshalyzer {

/// Generalised winding numbers of a set of triangles: how often it goes round a point. 1 inside a
/// closed outward surface, 0 outside, in between where it is open (Jacobson et al. 2013, "Robust
/// inside-outside segmentation using generalized winding numbers").
///
/// Triangles far from the point are taken together as dipoles (Barill et al. 2018, "Fast winding
/// numbers for soups and clouds"): the error is below 0.01 for a surface that goes round once. For
/// estimates and votes, never for what must be exact. Turning all triangles over by exchanging
/// their last two corners negates all answers, to the last bit.
class WindingNumbers {
 public:
  /// @complexity O(n log n).
  explicit WindingNumbers(std::vector<Corners> triangles);
  ~WindingNumbers();
  WindingNumbers(const WindingNumbers&) = delete;
  WindingNumbers& operator=(const WindingNumbers&) = delete;

  /// Safe to call from several threads. A point on triangles, or nearer to them than 1e-12 of the
  /// whole or than coordinates can tell, gets what lies half-way between their two sides; on their
  /// edges something in between.
  ///
  /// @complexity O(log n) on average.
  [[nodiscard]] double at(const Vec3& point) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace meshalyzer
