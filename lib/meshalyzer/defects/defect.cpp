#include "meshalyzer/defects/defect.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// In the order of DefectCode.
constexpr std::array<std::string_view, kDefectCodes> kNames{
    "disjoint",          "foldover",     "flat-facet",      "degenerate-facet", "slit",
    "self-intersection", "non-manifold", "vertex-normal",   "corrupt",          "hole",
    "flipped",           "inward",       "duplicate-facet", "orphan-vertex",    "numbering"};

constexpr std::array<DefectCode, kDefectCodes> make_codes() {
  std::array<DefectCode, kDefectCodes> codes{};
  for (std::size_t i = 0; i < kDefectCodes; ++i) codes[i] = static_cast<DefectCode>(i);
  return codes;
}

constexpr std::array<DefectCode, kDefectCodes> kCodes = make_codes();
static_assert(kCodes.back() == DefectCode::Numbering);

}  // namespace

const std::array<DefectCode, kDefectCodes>& all_defect_codes() {
  return kCodes;
}

std::string_view defect_name(DefectCode code) {
  return kNames[static_cast<std::size_t>(code)];
}

std::optional<DefectCode> defect_code(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return kCodes[static_cast<std::size_t>(found - kNames.begin())];
}

std::string_view severity_name(Severity severity) {
  return severity == Severity::Error ? "error" : "warning";
}

}  // namespace meshalyzer
