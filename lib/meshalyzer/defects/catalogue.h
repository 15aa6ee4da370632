#pragma once

#include "meshalyzer/defects/defect.h"

#include <span>
#include <string_view>

namespace meshalyzer {

/// How a measured value is told: "height 0.1", "1 face", "2 faces".
struct MeasuredWords {
  std::string_view before = "measured";
  std::string_view one = {};
  std::string_view many = {};
};

/// What is known of a code before any mesh is seen: doc/defects.md is made of this.
struct CatalogueEntry {
  DefectCode code;
  /// What programs call it: "flat-facet". Never changed.
  std::string_view name;
  /// A few words, for pages.
  std::string_view summary;
  Severity severity;
  /// A sentence.
  std::string_view meaning;
  /// What the measured value is, and the limit; empty where there is none.
  std::string_view value;
  /// The words round the measured value.
  MeasuredWords measured = {};
  /// Which elements and positions are listed.
  std::string_view elements;
  /// What meshfixer does about it.
  std::string_view fix;
  /// The pass, or passes, that do it, as logs name them.
  std::string_view passes;
  /// Whether it is fixed where nothing else is asked for.
  bool fixed_by_default;
};

/// One entry a code, in the order of DefectCode.
[[nodiscard]] std::span<const CatalogueEntry> defect_catalogue();

[[nodiscard]] const CatalogueEntry& catalogue_entry(DefectCode code);

/// A defect of this code, as severe as the catalogue says, of which nothing else is known yet.
[[nodiscard]] Defect make_defect(DefectCode code);

}  // namespace meshalyzer
