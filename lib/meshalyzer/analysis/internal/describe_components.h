#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/prepared/shells.h"
#include "meshalyzer/topology/component_counts.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// The sums over the faces of each component.
struct ComponentMeasures {
  std::vector<double> area;
  std::vector<Index> zero_area_faces;
};

/// What the steps of an analysis have found of each component, a list for each step; a list is
/// empty if its step was not asked for. The lists take less memory than the components that are
/// described from them, which matters where nearly every face is a component.
struct ComponentFindings {
  std::vector<ComponentCounts> counts;
  ComponentMeasures measures = {};
  std::vector<Box3> boxes = {};
  /// The number of intersecting pairs with at least one face in each.
  std::vector<std::size_t> intersecting_pairs = {};
  std::vector<Shell> shells = {};
};

/// Puts together what is known of each component.
[[nodiscard]] std::vector<ComponentAnalysis> describe_components(const ComponentFindings& found);

}  // namespace meshalyzer
