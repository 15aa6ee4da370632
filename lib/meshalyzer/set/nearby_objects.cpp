#include "meshalyzer/set/nearby_objects.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/set/box_distance.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns a box that contains everything within `reach` of another one, in spite of rounding.
Box3 box_within(double reach, const Box3& box) {
  constexpr double kRounding = 1e-15;
  const Vec3 grow =
      Vec3::Constant(reach) + kRounding * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  return {box.min() - grow, box.max() + grow};
}

}  // namespace

NearbyObjects::NearbyObjects(Index object, std::span<const Box3> boxes, const BoxTree& tree)
    : object_(object), boxes_(boxes), tree_(tree), given_{object} {}

std::vector<NearbyObjects::Candidate> NearbyObjects::within(double reach) {
  // This is a little less than the requested reach: no object that rounding has excluded is nearer.
  constexpr double kGrant = 1.0 - 1e-9;
  given_up_to_ = reach * kGrant;
  std::vector<Index> near = tree_.meeting(box_within(reach, boxes_[object_]));
  std::vector<Index> fresh;
  std::set_difference(near.begin(), near.end(), given_.begin(), given_.end(),
                      std::back_inserter(fresh));
  given_ = std::move(near);
  std::vector<Candidate> candidates;
  for (const Index other : fresh) {
    candidates.push_back(
        {distance(boxes_[object_], boxes_[other]),
         distance(Box3(middle_of(boxes_[object_])), Box3(middle_of(boxes_[other]))), other});
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

}  // namespace meshalyzer
