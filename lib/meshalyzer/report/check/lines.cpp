#include "meshalyzer/report/check/lines.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/report/format_text.h"

#include <algorithm>
#include <fmt/format.h>

namespace meshalyzer {

std::string shown_path(const FileFindings& file) {
  return without_controls(file.path);
}

std::string place_of(const FileFindings& file, const Finding& finding) {
  const std::string name = shown_path(file);
  return finding.line ? fmt::format("{}:{}", name, *finding.line) : name;
}

std::string place_of_error(const FileFindings& file) {
  const FilePlace place = file.error_place;
  const std::string name = shown_path(file);
  if (place.line != 0) return fmt::format("{}:{}", name, place.line);
  if (place.byte != FilePlace::kNoByte) return fmt::format("{}:byte {}", name, place.byte);
  return name;
}

std::string message_of(const Finding& finding) {
  return finding.fix.empty() ? finding.message
                             : fmt::format("{} ({})", finding.message, finding.fix);
}

std::size_t n_left_out(const FileFindings& file, const FindingCount& found) {
  const auto n_listed =
      std::count_if(file.findings.begin(), file.findings.end(),
                    [&](const Finding& finding) { return finding.code == found.code; });
  return found.count - static_cast<std::size_t>(n_listed);
}

std::string note_of(const FileFindings& file) {
  if (!file.format) return "";
  const std::string_view misleading = misleading_format(file.path, *file.format);
  return misleading.empty() ? ""
                            : fmt::format("read as {} by its content; its name says {}",
                                          format_name(*file.format), misleading);
}

std::string left_out_of(const FileFindings& file, const FindingCount& found) {
  const std::size_t n = n_left_out(file, found);
  if (n == 0) return "... and perhaps more";
  return fmt::format("... and {}{} more", found.is_at_least ? "at least " : "", grouped(n));
}

}  // namespace meshalyzer
