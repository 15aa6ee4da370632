#pragma once

#include "meshalyzer/mesh/soup.h"

#include <functional>

namespace meshalyzer::test {

/// The largest distance of a point of one mesh from the nearest point of another, by dense
/// sampling: nothing of the library's own geometry is used. Faces that are in no complex do not
/// count, those of zero area are the segment or point they are.
///
/// @param spacing  Every point of `from` is within it of a sample, corners are samples: the true
///                 distance is at least what is returned, and at most this much larger. Above 0.
/// @param counts   Which samples count: given a point and a normal of its face, not of unit length.
/// @return         0 where `from` has no faces, infinite where only `to` has none.
[[nodiscard]] double sampled_distance(
    const Soup& from, const Soup& to, double spacing,
    const std::function<bool(const Vec3& point, const Vec3& normal)>& counts = {});

/// How often faces go round a point, as the sum of the solid angles under which they are seen.
[[nodiscard]] double summed_winding(const Soup& soup, const Vec3& point);

}  // namespace meshalyzer::test
