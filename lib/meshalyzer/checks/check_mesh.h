#pragma once

#include "meshalyzer/checks/criteria.h"
#include "meshalyzer/checks/finding.h"
#include "meshalyzer/mesh/soup.h"

#include <string>

namespace meshalyzer {

/// Checks one mesh against criteria. One with a position that is not finite, which is corrupt, is
/// held to no limit.
///
/// The result is the same for any number of threads.
///
/// @param soup  The file, taken by value: it is freed with its search structures.
/// @param path  The name of the file in the result.
/// @throws InvalidArgument  as resolve_tolerances() and build(); and if a limit is NaN.
/// @complexity  O(#F log #F) for meshes whose faces meet few others; for others the search ends
///              after max_pairs intersecting pairs.
[[nodiscard]] FileFindings check_mesh(Soup soup, std::string path, const CheckCriteria& criteria);

}  // namespace meshalyzer
