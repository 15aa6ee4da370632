#include "meshalyzer/picture/internal/drawing_frame.h"

#include "meshalyzer/base/box.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// Meshes of a size between these are not scaled: lengths, areas and volumes have enough digits in
/// single precision, and stay above the tolerances of viewers.
constexpr int kSmallestExponent = -3;
constexpr int kLargestExponent = 17;

double scale_for_size(double half) {
  const int exponent = std::ilogb(half);
  if (exponent >= kSmallestExponent && exponent <= kLargestExponent) return 1.0;
  // The scale is a normal double, so that dividing by it is exact too.
  return std::ldexp(1.0, std::clamp(-exponent, -1022, 1022));
}

}  // namespace

DrawingFrame::DrawingFrame(const Box3& box) {
  if (box.isEmpty()) return;
  centre_ = middle_of(box);
  const Vec3 half = half_widths_of(box);
  if (!(half.maxCoeff() > 0.0)) return;
  scale_ = scale_for_size(half.maxCoeff());
  radius_ = (half * scale_).norm();
}

void append_point(std::vector<float>& array, const Vec3& drawn) {
  for (const double x : drawn) array.push_back(static_cast<float>(x));
}

}  // namespace meshalyzer
