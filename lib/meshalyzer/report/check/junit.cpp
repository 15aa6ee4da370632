#include "meshalyzer/report/check/formats.h"
#include "meshalyzer/report/check/lines.h"
#include "meshalyzer/report/html/writer.h"

#include <fmt/format.h>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns a text for XML, which escapes the same characters as HTML.
std::string escaped(std::string_view text) {
  std::string xml;
  append_escaped_html(xml, text);
  return xml;
}

/// Returns a text for the value of an attribute; readers of XML make spaces of line ends and
/// tabulators that are written as such.
std::string escaped_value(std::string_view text) {
  std::string value;
  for (const char c : escaped(text)) {
    if (c == '\n' || c == '\t') {
      value += c == '\n' ? "&#10;" : "&#9;";
    } else {
      value += c;
    }
  }
  return value;
}

/// Returns a summary such as "self-intersection: at least 85, hole: 2".
std::string summary_of(const FileFindings& file) {
  std::string text;
  for (const FindingCount& found : file.counts) {
    text += fmt::format("{}{}: {}{}", text.empty() ? "" : ", ", found.code,
                        found.is_at_least ? "at least " : "", found.count);
  }
  return text;
}

std::string lines_of(const FileFindings& file) {
  std::string lines;
  make_check_text([&](std::string_view text) { lines += text; }, TextColour::Never)->add(file);
  return lines;
}

class CheckJunit : public CheckReport {
 public:
  explicit CheckJunit(TextSink sink) : sink_(std::move(sink)) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
  std::string cases_;
};

void CheckJunit::add(const FileFindings& file) {
  cases_ += fmt::format("    <testcase classname=\"meshalyzer.check\" name=\"{}\" time=\"0\"",
                        escaped_value(file.path));
  const std::string note = note_of(file);
  const std::string output =
      note.empty() ? "" : fmt::format("      <system-out>{}</system-out>\n", escaped(note));
  if (file.is_good()) {
    cases_ += output.empty() ? "/>\n" : fmt::format(">\n{}    </testcase>\n", output);
    return;
  }
  const std::string_view tag = file.is_readable() ? "failure" : "error";
  cases_ +=
      fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n{4}    </testcase>\n", tag,
                  file.is_readable() ? "not good" : kUnreadable,
                  escaped_value(file.is_readable() ? summary_of(file) : file.error),
                  escaped(lines_of(file)), output);
}

void CheckJunit::finish(const CheckTotals& totals, std::chrono::duration<double> /*elapsed*/) {
  const std::string numbers =
      fmt::format("name=\"meshalyzer check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"0\"",
                  totals.meshes, totals.not_good, totals.unreadable);
  sink_(
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n  <testsuite "
                  "{0}>\n{1}  </testsuite>\n</testsuites>\n",
                  numbers, cases_));
}

}  // namespace

std::unique_ptr<CheckReport> make_check_junit(TextSink sink) {
  return std::make_unique<CheckJunit>(std::move(sink));
}

}  // namespace meshalyzer
