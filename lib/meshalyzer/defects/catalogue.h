#pragma once

#include "meshalyzer/defects/defect.h"

#include <span>
#include <string_view>

namespace meshalyzer {

/// The words for a measured value: "height 0.1", "1 face", "2 faces".
struct MeasuredWords {
  std::string_view before = "measured";
  std::string_view one = {};
  std::string_view many = {};
};

/// Describes a defect code for users; doc/defects.md is made of these descriptions.
struct CatalogueEntry {
  DefectCode code;
  /// The name for programs, such as "flat-facet". It never changes.
  std::string_view name;
  /// Describes the defect in a few words, for pages.
  std::string_view summary;
  Severity severity;
  /// Says in sentences when a mesh has the defect.
  std::string_view meaning;
  /// Says what Defect::value and Defect::limit are; empty where the defect has none.
  std::string_view value;
  /// The words round the measured value.
  MeasuredWords measured = {};
  /// Says which elements and positions a defect lists.
  std::string_view elements;
  /// Says what repair does about the defect.
  std::string_view fix;
  /// Names in a few words what mends the defect: "meshfixer splits it".
  std::string_view fix_summary;
  /// Names the repair passes that do it, as repair logs name them.
  std::string_view passes;
  /// Tells whether repair mends the defect unless told otherwise.
  bool fixed_by_default;
};

/// Returns one entry for each code, in the order of DefectCode.
[[nodiscard]] std::span<const CatalogueEntry> defect_catalogue();

/// Returns the entry of one code.
[[nodiscard]] const CatalogueEntry& catalogue_entry(DefectCode code);

/// Tells whether each defect of a code is a whole component, which its first face represents.
[[nodiscard]] constexpr bool is_whole_component(DefectCode code) {
  return code == DefectCode::Disjoint || code == DefectCode::Inward;
}

/// Returns a defect that has this code and the severity of its entry, and is empty otherwise.
[[nodiscard]] Defect make_defect(DefectCode code);

}  // namespace meshalyzer
