#include "meshalyzer/report/check/lines.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/base/grouped_digits.h"
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

std::optional<std::size_t> error_line(const FileFindings& file) {
  const std::size_t line = file.error_place.line;
  return line == 0 ? std::nullopt : std::optional(line);
}

std::string place_of_error(const FileFindings& file) {
  const FilePlace place = file.error_place;
  const std::string name = shown_path(file);
  if (const auto line = error_line(file)) return fmt::format("{}:{}", name, *line);
  if (place.byte != FilePlace::kNoByte) return fmt::format("{}:byte {}", name, place.byte);
  return name;
}

std::string message_of(const Finding& finding) {
  return finding.fix.empty() ? finding.message
                             : fmt::format("{} ({})", finding.message, finding.fix);
}

std::string note_of(const FileFindings& file) {
  if (!file.format) return "";
  const std::string_view misleading = misleading_format(file.path, *file.format);
  return misleading.empty() ? ""
                            : fmt::format("read as {} by its content; its name says {}",
                                          format_name(*file.format), misleading);
}

std::string left_out_of(const FileFindings& file, const FindingCount& found) {
  const auto n_listed =
      std::count_if(file.findings.begin(), file.findings.end(),
                    [&](const Finding& finding) { return finding.code == found.code; });
  const std::size_t n = found.count - static_cast<std::size_t>(n_listed);
  if (n == 0) return found.is_at_least ? "... and perhaps more" : "";
  return fmt::format("... and {}{} more", found.is_at_least ? "at least " : "", grouped(n));
}

}  // namespace meshalyzer
