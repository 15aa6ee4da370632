#include "meshalyzer/report/check/formats.h"
#include "meshalyzer/report/check/lines.h"

#include <fmt/format.h>
#include <utility>

namespace meshalyzer {
namespace {

/// Percent-encodes characters that would end the text or be taken for a part of the command.
std::string encoded(std::string_view text, std::string_view reserved) {
  std::string result;
  for (const char c : text) {
    if (reserved.find(c) == std::string_view::npos) {
      result += c;
    } else {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return result;
}

std::string message(std::string_view text) {
  return encoded(text, "%\r\n");
}

std::string property(std::string_view text) {
  return encoded(text, "%\r\n:,");
}

std::string at_line(std::optional<std::size_t> line) {
  return line ? fmt::format(",line={}", *line) : "";
}

class CheckGithub : public CheckReport {
 public:
  explicit CheckGithub(TextSink sink) : sink_(std::move(sink)) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
};

void CheckGithub::add(const FileFindings& file) {
  if (!file.is_readable()) {
    sink_(fmt::format("::error file={}{},title={}::{}\n", property(file.path),
                      at_line(error_line(file)), kUnreadable, message(file.error)));
  }
  if (const std::string note = note_of(file); !note.empty()) {
    sink_(fmt::format("::notice file={},title=format::{}\n", property(file.path), message(note)));
  }
  for (const Finding& finding : file.findings) {
    sink_(fmt::format("::{} file={}{},title={}::{}\n", severity_name(finding.severity),
                      property(file.path), at_line(finding.line), property(finding.code),
                      message(message_of(finding))));
  }
  for (const FindingCount& found : file.counts) {
    const std::string rest = left_out_of(file, found);
    if (rest.empty()) continue;
    sink_(fmt::format("::{} file={},title={}::{}\n", severity_name(found.severity),
                      property(file.path), property(found.code), message(rest)));
  }
}

void CheckGithub::finish(const CheckTotals& totals, std::chrono::duration<double> /*elapsed*/) {
  sink_(fmt::format("::notice title=meshalyzer check::{} good, {} not good, {} unreadable\n",
                    totals.good, totals.not_good, totals.unreadable));
}

}  // namespace

std::unique_ptr<CheckReport> make_check_github(TextSink sink) {
  return std::make_unique<CheckGithub>(std::move(sink));
}

}  // namespace meshalyzer
