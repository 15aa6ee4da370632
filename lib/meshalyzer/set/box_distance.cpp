#include "meshalyzer/set/box_distance.h"

namespace meshalyzer {

double distance(const Box3& a, const Box3& b) {
  const Vec3 gap = (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(Vec3::Zero());
  // Neither overflow nor underflow may create a gap or hide one.
  return gap.stableNorm();
}

}  // namespace meshalyzer
