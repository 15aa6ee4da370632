#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/internal/complex_topology.h"

#include <span>

namespace meshalyzer {

/// Answers for each component what its counts decide: closed, manifold, orientable, consistent,
/// genus.
[[nodiscard]] std::vector<ComponentAnalysis> analyze_components(
    std::span<const ComponentCounts> counts);

/// Fills in the counts of Characteristics that follow from topology and integrity.
///
/// @param analysis  Knows its components and offenders.
void count_elements(const Soup& soup, const ComplexTopology& topology, Analysis& analysis);

/// Returns the five attributes of the mesh, from what is counted and decided of its components.
///
/// @param orientable  Whether its faces can be given a consistent orientation.
[[nodiscard]] Attributes answer_attributes(const Analysis& analysis, bool orientable);

/// Returns the volume of the mesh: that of its components added up, where it bounds a solid.
[[nodiscard]] Measure<double> total_volume(const Analysis& analysis);

/// Adds up the genus of the components, unless orphan vertices forbid it ("Characteristics: counts"
/// in doc/definitions.md).
///
/// Sets Characteristics::genus and genus_of_components.
void answer_genus(Analysis& analysis);

}  // namespace meshalyzer
