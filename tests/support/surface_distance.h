#pragma once

#include "meshalyzer/mesh/soup.h"

#include <functional>

namespace meshalyzer::test {

/// Returns the largest distance of a point of one mesh from the nearest point of another, by dense
/// sampling, without any geometry of the library. Faces that are in no complex do not count; those
/// of zero area are the segment or point that they are.
///
/// @param spacing  Every point of `from` is within it of a sample, and corners are samples: the
/// true distance is at least the result, and at most this much larger. Above 0.
/// @param counts   Returns whether a sample counts, given the point and a normal of its face, not
/// of unit length.
/// @return         0 if `from` has no faces, infinite if only `to` has none.
[[nodiscard]] double sampled_distance(
    const Soup& from, const Soup& to, double spacing,
    const std::function<bool(const Vec3& point, const Vec3& normal)>& counts = {});

/// Returns the winding number of faces round a point, as the sum of the solid angles that they
/// subtend.
[[nodiscard]] double summed_winding(const Soup& soup, const Vec3& point);

}  // namespace meshalyzer::test
