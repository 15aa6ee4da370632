#pragma once

#include "meshalyzer/checks/criteria.h"
#include "meshalyzer/checks/finding.h"
#include "meshalyzer/mesh/soup.h"

#include <string>

namespace meshalyzer {

/// Checks one mesh against criteria.
///
/// The result is the same for any number of threads.
///
/// @param soup  The file. Taken by value: it is freed with what was built for it.
/// @param path  What the result calls it.
/// @throws InvalidArgument  where resolve_tolerances() does.
/// @complexity  O(#F log #F) for meshes whose faces meet few others; of others no more than
/// max_pairs intersecting pairs are looked for.
[[nodiscard]] FileFindings check_mesh(Soup soup, std::string path, const CheckCriteria& criteria);

}  // namespace meshalyzer
