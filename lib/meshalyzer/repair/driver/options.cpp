#include "meshalyzer/repair/driver/options.h"

#include "meshalyzer/base/require.h"

#include <algorithm>
#include <limits>

namespace meshalyzer {
namespace {

/// The numbers of intersecting pairs that a repair handles by default: so many in any mesh, and so
/// many a face in large ones. Files in which every face has its own vertices have six a face.
constexpr std::size_t kMostPairs = 4'000'000;
constexpr std::size_t kMostPairsPerFace = 32;

}  // namespace

DefectCodes default_fixes() {
  DefectCodes codes = DefectCodes::all();
  codes.erase(DefectCode::Disjoint);
  codes.erase(DefectCode::Numbering);
  return codes;
}

double length_of(const Deviation& deviation, const Box3& box) {
  require_length("the maximum deviation", deviation.value);
  if (deviation.unit == Deviation::Unit::Length) return deviation.value;
  if (box.isEmpty()) return 0.0;
  // The diagonal itself may be too large for a double.
  const Vec3 quarter = box.max() / 4 - box.min() / 4;
  return std::min(quarter.stableNorm() * (4 * deviation.value), std::numeric_limits<double>::max());
}

PairLimits pair_limits(const RepairOptions& options, std::size_t n_faces) {
  const std::size_t most = std::max(kMostPairs, kMostPairsPerFace * n_faces);
  return {.max_found = options.max_pairs.value_or(most), .wants_to_stop = options.wants_to_stop};
}

}  // namespace meshalyzer
