#include "meshalyzer/checks/limits.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/report/check/formats.h"
#include "meshalyzer/report/check/lines.h"
#include "meshalyzer/report/html/writer.h"
#include "meshalyzer/report/json/writer.h"

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Writes an object with only a text, as which SARIF writes messages and descriptions. Braces are
/// doubled: single ones would enclose the number of an argument.
void write_text(JsonWriter& json, std::string_view name, std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped.append(c == '{' || c == '}' ? 2 : 1, c);
  json.key(name);
  json.begin_object(JsonLayout::Row);
  json.member("text", escaped);
  json.end_object();
}

void write_rule(JsonWriter& json, std::string_view id, std::string_view summary,
                std::string_view meaning) {
  json.begin_object();
  json.member("id", id);
  write_text(json, "shortDescription", summary);
  write_text(json, "fullDescription", meaning);
  json.end_object();
}

void write_rules(JsonWriter& json) {
  json.key("rules");
  json.begin_array();
  for (const CatalogueEntry& entry : defect_catalogue()) {
    write_rule(json, entry.name, entry.summary, entry.meaning);
  }
  for (const LimitInfo& info : limit_table()) write_rule(json, info.name, info.quantity, info.help);
  write_rule(json, kUnreadable, "a file that cannot be read",
             "The file is not there, or its content is not of its format.");
  json.end_array();
}

void write_place(JsonWriter& json, std::string_view address,
                 std::optional<std::size_t> line = std::nullopt) {
  json.key("locations");
  json.begin_array(JsonLayout::Row);
  json.begin_object();
  json.key("physicalLocation");
  json.begin_object();
  json.key("artifactLocation");
  json.begin_object();
  json.member("uri", address);
  json.end_object();
  if (line) {
    json.key("region");
    json.begin_object();
    json.member("startLine", *line);
    json.end_object();
  }
  json.end_object();
  json.end_object();
  json.end_array();
}

void write_result(JsonWriter& json, std::string_view code, Severity severity,
                  std::string_view message) {
  json.member("ruleId", code);
  json.member("level", severity_name(severity));
  write_text(json, "message", message);
}

class CheckSarif : public CheckReport {
 public:
  explicit CheckSarif(TextSink sink);

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  void write_artifacts();
  void write_notes();

  TextSink sink_;
  JsonWriter json_;
  /// The addresses of all files, for "artifacts"; a file may be named more than once.
  std::vector<std::string> addresses_;
  struct Note {
    std::string address;
    std::string text;
  };
  /// The notes on files, for "toolExecutionNotifications".
  std::vector<Note> notes_;
};

CheckSarif::CheckSarif(TextSink sink) : sink_(std::move(sink)) {
  json_.begin_object();
  json_.member("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
  json_.member("version", "2.1.0");
  json_.key("runs");
  json_.begin_array();
  json_.begin_object();
  json_.key("tool");
  json_.begin_object();
  json_.key("driver");
  json_.begin_object();
  json_.member("name", "meshalyzer");
  json_.member("version", MESHALYZER_VERSION);
  write_rules(json_);
  json_.end_object();
  json_.end_object();
  json_.key("results");
  json_.begin_array();
}

void CheckSarif::add(const FileFindings& file) {
  addresses_.push_back(address_of(file.path));
  if (std::string note = note_of(file); !note.empty()) {
    notes_.push_back({addresses_.back(), std::move(note)});
  }
  if (!file.is_readable()) {
    json_.begin_object();
    write_result(json_, kUnreadable, Severity::Error, file.error);
    write_place(json_, addresses_.back(), error_line(file));
    json_.end_object();
  }
  for (const Finding& finding : file.findings) {
    json_.begin_object();
    write_result(json_, finding.code, finding.severity, message_of(finding));
    write_place(json_, addresses_.back(), finding.line);
    json_.end_object();
  }
  for (const FindingCount& found : file.counts) {
    const std::string rest = left_out_of(file, found);
    if (rest.empty()) continue;
    json_.begin_object();
    write_result(json_, found.code, found.severity, rest);
    write_place(json_, addresses_.back());
    json_.end_object();
  }
  sink_(json_.drain());
}

void CheckSarif::write_artifacts() {
  json_.key("artifacts");
  json_.begin_array();
  std::set<std::string_view> written;
  for (const std::string& address : addresses_) {
    if (!written.insert(address).second) continue;
    json_.begin_object(JsonLayout::Row);
    json_.key("location");
    json_.begin_object();
    json_.member("uri", address);
    json_.end_object();
    json_.end_object();
  }
  json_.end_array();
}

void CheckSarif::write_notes() {
  json_.key("toolExecutionNotifications");
  json_.begin_array();
  for (const Note& note : notes_) {
    json_.begin_object();
    json_.member("level", "note");
    write_text(json_, "message", note.text);
    write_place(json_, note.address);
    json_.end_object();
  }
  json_.end_array();
}

void CheckSarif::finish(const CheckTotals& totals, std::chrono::duration<double> /*elapsed*/) {
  json_.end_array();
  write_artifacts();
  json_.key("invocations");
  json_.begin_array();
  json_.begin_object(JsonLayout::Row);
  json_.member("executionSuccessful", totals.unreadable == 0);
  write_notes();
  json_.end_object();
  json_.end_array();
  json_.end_object();
  json_.end_array();
  json_.end_object();
  sink_(json_.take());
}

}  // namespace

std::unique_ptr<CheckReport> make_check_sarif(TextSink sink) {
  return std::make_unique<CheckSarif>(std::move(sink));
}

}  // namespace meshalyzer
