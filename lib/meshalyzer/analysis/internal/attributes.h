#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/internal/complex_topology.h"

namespace meshalyzer {

/// Fills in the counts of Characteristics that are of the file's records.
void count_records(const Soup& soup, Characteristics& characteristics);

/// Fills in the counts of Characteristics that follow from topology.
///
/// @param analysis  The analysis, whose offenders are set.
void count_elements(const ComplexTopology& topology, Analysis& analysis);

/// Returns the five attributes of the mesh, from its counts and those of its components.
///
/// @param orientable  True if its faces can be given a consistent orientation.
[[nodiscard]] Attributes answer_attributes(const Analysis& analysis, bool orientable);

/// Adds up the genus of the components, unless orphan vertices forbid it ("Characteristics: counts"
/// in doc/definitions.md).
///
/// The result is stored in Characteristics::genus and genus_of_components.
void answer_genus(Analysis& analysis);

}  // namespace meshalyzer
