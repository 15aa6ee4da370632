#include "meshalyzer/checks/selection.h"
#include "meshalyzer/report/check/formats.h"
#include "meshalyzer/report/check/lines.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/format.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/writer.h"

#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::string_view kCheckSchema = "meshalyzer-check/1";

void write_finding(JsonWriter& json, const Finding& finding) {
  json.begin_object(JsonLayout::Row);
  json.member("code", finding.code);
  json.member("severity", severity_name(finding.severity));
  json.member("message", finding.message);
  json.key("fix");
  finding.fix.empty() ? json.null() : json.value(finding.fix);
  json.member("line", finding.line);
  json.key("vertices");
  json.array(finding.vertices);
  json.key("faces");
  json.array(finding.faces);
  json.key("position");
  finding.position ? json.array(*finding.position) : json.null();
  json.member("value", finding.value);
  json.member("at_least", finding.is_at_least);
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
  const std::size_t byte = file.error_place.byte;
  json.begin_object(JsonLayout::Row);
  json.member("message", file.error);
  json.member("line", error_line(file));
  json.member("byte", byte == FilePlace::kNoByte ? std::nullopt : std::optional(byte));
  json.end_object();
}

void write_file(JsonWriter& json, const FileFindings& file) {
  write_bytes(json, "path", file.path);
  if (file.format) write_format(json, file.path, *file.format);
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
  json.member("version", MESHALYZER_VERSION);
}

/// Returns the keywords of a list whose items are a definition.
std::string list_of(std::string_view definition) {
  return R"("type": "array", "items": {)" + schema_reference(definition) + "}";
}

std::string code_type() {
  return schema_enum(all_check_codes());
}

std::string severity_type() {
  return schema_enum({severity_name(Severity::Error), severity_name(Severity::Warning)});
}

void define_finding(SchemaDefinitions& schema) {
  const std::string ids = R"("type": "array", "items": {"type": "integer"}, "maxItems": )" +
                          std::to_string(Finding::kMaxElements);
  schema.define(
      "finding",
      {.description = "a fault of a mesh",
       .members = {
           {"code", "", code_type()},
           {"severity", "", severity_type()},
           {"message", "one sentence without full stop", schema_type::kText},
           {"fix", "how meshfixer mends it; null where it does not",
            R"("type": ["string", "null"])"},
           {"line", "of the record that the message names first; null where there are no lines",
            R"("type": ["integer", "null"], "minimum": 1)"},
           {"vertices", "ids of the file, the first few", ids},
           {"faces", "ids of the file, the first few", ids},
           {"position", "", R"("type": ["array", "null"], "items": {"type": "number"})"},
           {"value", "the measured value", schema_type::kReal},
           {"at_least", "whether the value may be larger, since the search ended early",
            schema_type::kTruth},
           {"limit", "the limit that the value passes", schema_type::kReal}}});
}

void define_count(SchemaDefinitions& schema) {
  schema.define("count",
                {.description = "how often something was found",
                 .members = {{"code", "", code_type()},
                             {"severity", "", severity_type()},
                             {"count", "whether listed or not", schema_type::kCount},
                             {"at_least",
                              "whether there may be more, since the search ended "
                              "early",
                              schema_type::kTruth},
                             {"fixable", "those that meshfixer mends", schema_type::kCount}}});
}

void define_error(SchemaDefinitions& schema) {
  schema.define("error", {.description = "why a file cannot be read; null where it can",
                          .members = {{"message", "", schema_type::kText},
                                      {"line", "from 1", schema_type::kCountOrNull},
                                      {"byte", "from 0", schema_type::kCountOrNull}},
                          .null = SchemaObject::Null::Sometimes});
}

void define_file(SchemaDefinitions& schema) {
  SchemaObject file{.description = "", .members = path_members()};
  for (SchemaMember& member : format_members()) {
    member.presence = SchemaMember::Presence::Sometimes;  // an unreadable file has no format
    file.members.push_back(std::move(member));
  }
  const std::vector<SchemaMember> parts{
      {"good", "without a finding", schema_type::kTruth},
      {"error", "", schema_reference("error")},
      {"vertices", "", schema_type::kCount},
      {"faces", "", schema_type::kCount},
      {"counts", "one for each code that was found", list_of("count")},
      {"findings", "errors before warnings, the first ones of each code", list_of("finding")}};
  file.members.insert(file.members.end(), parts.begin(), parts.end());
  schema.define("mesh", file);
}

void define_totals(SchemaDefinitions& schema) {
  SchemaObject totals{.description = "of all files"};
  for (const std::string_view key :
       {"meshes", "good", "not_good", "unreadable", "errors", "warnings", "fixable"}) {
    totals.members.push_back({std::string(key), "", schema_type::kCount});
  }
  totals.members.push_back({"at_least", "whether there may be more errors", schema_type::kTruth});
  schema.define("totals", totals);
}

SchemaObject check_object() {
  return {.description =
              "A report of meshalyzer check. A program may rely on these keys; more may "
              "be added. See doc/check.md.",
          .members = {{"version", "", schema_type::kText},
                      {"meshes", "in the order of the command line, those of a folder by name",
                       list_of("mesh")},
                      {"totals", "", schema_reference("totals")}}};
}

class CheckJson : public CheckReport {
 public:
  explicit CheckJson(TextSink sink);

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
  JsonWriter json_;
};

class CheckNdjson : public CheckReport {
 public:
  explicit CheckNdjson(TextSink sink) : sink_(std::move(sink)) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
};

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

}  // namespace

std::unique_ptr<CheckReport> make_check_json(TextSink sink) {
  return std::make_unique<CheckJson>(std::move(sink));
}

std::unique_ptr<CheckReport> make_check_ndjson(TextSink sink) {
  return std::make_unique<CheckNdjson>(std::move(sink));
}

std::string check_json_schema() {
  return schema_document(kCheckSchema, check_object(), [](SchemaDefinitions& definitions) {
    define_file(definitions);
    define_error(definitions);
    define_count(definitions);
    define_finding(definitions);
    define_totals(definitions);
  });
}

}  // namespace meshalyzer
