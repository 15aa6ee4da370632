#pragma once

#include "meshalyzer/analysis/analysis.h"

namespace meshalyzer {

/// Checks a file's records and their numbering ("Integrity" in doc/definitions.md).
///
/// @param offenders  Receives the offending records: its lists of orphan and missing vertices,
///                   degenerate faces, faces with missing vertices, duplicate ids, and the breaks
///                   of numbering.
/// @complexity       O(#V + #F), apart from sorting ids that the file names out of order.
[[nodiscard]] Integrity check_integrity(const Soup& soup, Offenders& offenders);

}  // namespace meshalyzer
