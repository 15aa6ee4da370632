#include "meshalyzer/report/check/json.h"

#include "meshalyzer/report/json/bytes.h"

namespace meshalyzer {
namespace {

constexpr std::string_view kCheckSchema = "meshalyzer-check/1";

void write_ids(JsonWriter& json, std::string_view name, const std::vector<std::int64_t>& ids) {
  json.key(name);
  json.begin_array(JsonLayout::Row);
  for (const std::int64_t id : ids) json.value(id);
  json.end_array();
}

void write_finding(JsonWriter& json, const Finding& finding) {
  json.begin_object(JsonLayout::Row);
  json.member("code", finding.code);
  json.member("severity", severity_name(finding.severity));
  json.member("message", std::string_view(finding.message));
  json.key("fix");
  finding.fix.empty() ? json.null() : json.value(finding.fix);
  json.member("line", finding.line);
  write_ids(json, "vertices", finding.vertices);
  write_ids(json, "faces", finding.faces);
  json.key("position");
  if (finding.position) {
    json.begin_array(JsonLayout::Row);
    for (const double coordinate : *finding.position) json.value(coordinate);
    json.end_array();
  } else {
    json.null();
  }
  json.member("value", finding.value);
  json.member("limit", finding.limit);
  json.end_object();
}

void write_count(JsonWriter& json, const FindingCount& found) {
  json.begin_object(JsonLayout::Row);
  json.member("code", found.code);
  json.member("severity", severity_name(found.severity));
  json.member("count", found.count);
  json.member("at_least", found.is_at_least);
  json.member("fixable", found.fixable);
  json.end_object();
}

void write_error(JsonWriter& json, const FileFindings& file) {
  json.key("error");
  if (file.is_readable()) {
    json.null();
    return;
  }
  const FilePlace place = file.trouble_place;
  json.begin_object(JsonLayout::Row);
  json.member("message", std::string_view(file.trouble));
  json.member("line", place.line == 0 ? std::nullopt : std::optional(place.line));
  json.member("byte", place.byte == FilePlace::kNoByte ? std::nullopt : std::optional(place.byte));
  json.end_object();
}

void write_file(JsonWriter& json, const FileFindings& file) {
  write_bytes(json, "path", file.path);
  json.member("good", file.is_good());
  write_error(json, file);
  json.member("vertices", file.vertices);
  json.member("faces", file.faces);
  json.key("counts");
  json.begin_array();
  for (const FindingCount& found : file.counts) write_count(json, found);
  json.end_array();
  json.key("findings");
  json.begin_array();
  for (const Finding& finding : file.findings) write_finding(json, finding);
  json.end_array();
}

void write_totals(JsonWriter& json, const CheckTotals& totals) {
  json.key("totals");
  json.begin_object();
  json.member("meshes", totals.meshes);
  json.member("good", totals.good);
  json.member("not_good", totals.not_good);
  json.member("unreadable", totals.unreadable);
  json.member("errors", totals.errors);
  json.member("warnings", totals.warnings);
  json.member("fixable", totals.fixable);
  json.member("at_least", totals.is_at_least);
  json.end_object();
}

void write_head(JsonWriter& json) {
  json.member("schema", kCheckSchema);
  json.member("version", std::string_view(MESHALYZER_VERSION));
}

}  // namespace

CheckJson::CheckJson(TextSink sink) : sink_(std::move(sink)) {
  json_.begin_object();
  write_head(json_);
  json_.key("meshes");
  json_.begin_array();
}

void CheckJson::add(const FileFindings& file) {
  json_.begin_object();
  write_file(json_, file);
  json_.end_object();
  sink_(json_.drain());
}

void CheckJson::finish(const CheckTotals& totals, std::chrono::duration<double> /*elapsed*/) {
  json_.end_array();
  write_totals(json_, totals);
  json_.end_object();
  sink_(json_.take());
}

void CheckNdjson::add(const FileFindings& file) {
  JsonWriter json;
  json.begin_object(JsonLayout::Row);
  write_file(json, file);
  json.end_object();
  sink_(json.take());
}

void CheckNdjson::finish(const CheckTotals& totals, std::chrono::duration<double> /*elapsed*/) {
  JsonWriter json;
  json.begin_object(JsonLayout::Row);
  write_head(json);
  write_totals(json, totals);
  json.end_object();
  sink_(json.take());
}

}  // namespace meshalyzer
