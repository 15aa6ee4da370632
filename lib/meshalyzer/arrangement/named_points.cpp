#include "meshalyzer/arrangement/named_points.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Points in one task: each takes a microsecond or more.
constexpr std::size_t kPointsAtOnce = 256;

}  // namespace

NamedPoints::NamedPoints(const Soup& soup, std::vector<PointName> names)
    : names_(std::move(names)) {
  points_.resize(names_.size());
  parallel_chunks(names_.size(), kPointsAtOnce, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      points_[i] = construct_point(soup, names_[i]);
    }
  });
}

Index NamedPoints::find(const PointName& name) const {
  return static_cast<Index>(std::lower_bound(names_.begin(), names_.end(), name) - names_.begin());
}

}  // namespace meshalyzer
