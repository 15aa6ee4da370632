#pragma once

#include "meshalyzer/mesh/soup.h"

namespace meshalyzer::test {

/// The largest distance of a point of one mesh from the nearest point of another, by dense
/// sampling: nothing of the library's own geometry is used. Faces that are in no complex do not
/// count, those of zero area are the segment or point they are.
///
/// @param spacing  Every point of `from` is within it of a sample, corners are samples: the true
///                 distance is at least what is returned, and at most this much larger. Above 0.
/// @return         0 where `from` has no faces, infinite where only `to` has none.
[[nodiscard]] double sampled_distance(const Soup& from, const Soup& to, double spacing);

}  // namespace meshalyzer::test
