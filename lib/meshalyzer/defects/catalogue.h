#pragma once

#include "meshalyzer/defects/defect.h"

#include <span>
#include <string_view>

namespace meshalyzer {

/// What is known of a code before any mesh is seen: doc/defects.md is made of this.
struct CatalogueEntry {
  DefectCode code;
  Severity severity;
  /// A sentence.
  std::string_view meaning;
  /// What the measured value is, and the limit; empty where there is none.
  std::string_view value;
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
