#include "meshalyzer/defects/defect.h"

namespace meshalyzer {
namespace {

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

std::string_view severity_name(Severity severity) {
  return severity == Severity::Error ? "error" : "warning";
}

}  // namespace meshalyzer
