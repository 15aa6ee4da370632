#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/check/formats.h"
#include "meshalyzer/report/check/lines.h"

#include <fmt/format.h>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

class CheckText : public CheckReport {
 public:
  CheckText(TextSink sink, TextColour colour) : sink_(std::move(sink)), colour_(colour) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  [[nodiscard]] std::string coloured(Severity severity, std::string_view text) const;

  TextSink sink_;
  TextColour colour_;
};

std::string CheckText::coloured(Severity severity, std::string_view text) const {
  if (colour_ == TextColour::Never) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", severity == Severity::Error ? "1;31" : "1;33", text);
}

void CheckText::add(const FileFindings& file) {
  if (!file.is_readable()) {
    sink_(fmt::format("{}: {}[{}]: {}\n", place_of_error(file), coloured(Severity::Error, "error"),
                      kUnreadable, file.error));
    return;
  }
  if (const std::string note = note_of(file); !note.empty()) {
    sink_(fmt::format("{}: note: {}\n", shown_path(file), note));
  }
  auto finding = file.findings.begin();
  for (const FindingCount& found : file.counts) {
    for (; finding != file.findings.end() && finding->code == found.code; ++finding) {
      sink_(fmt::format("{}: {}[{}]: {}\n", place_of(file, *finding),
                        coloured(found.severity, severity_name(found.severity)), found.code,
                        message_of(*finding)));
    }
    if (const std::string rest = left_out_of(file, found); !rest.empty()) {
      sink_(fmt::format("{}: {} {}\n", shown_path(file), rest, found.code));
    }
  }
}

void CheckText::finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) {
  std::string parts;
  const auto part = [&](const std::string& text) { parts += (parts.empty() ? "" : ", ") + text; };
  if (totals.good != 0) part(grouped(totals.good) + " good");
  if (totals.not_good != 0) {
    part(fmt::format("{} not ({}{}, {}; {} fixable)", grouped(totals.not_good),
                     totals.is_at_least ? "at least " : "",
                     counted(totals.errors, "error", "errors"),
                     counted(totals.warnings, "warning", "warnings"), grouped(totals.fixable)));
  }
  if (totals.unreadable != 0) part(grouped(totals.unreadable) + " unreadable");
  sink_(fmt::format("{} in {:.1f} s: {}\n", counted(totals.meshes, "mesh", "meshes"),
                    elapsed.count(), parts.empty() ? "nothing to check" : parts));
}

}  // namespace

std::unique_ptr<CheckReport> make_check_text(TextSink sink, TextColour colour) {
  return std::make_unique<CheckText>(std::move(sink), colour);
}

}  // namespace meshalyzer
