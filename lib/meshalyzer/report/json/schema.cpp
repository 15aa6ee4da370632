#include "meshalyzer/report/json/schema.h"

#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/curvature.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/offenders.h"
#include "meshalyzer/report/json/point.h"
#include "meshalyzer/report/json/set.h"
#include "meshalyzer/report/json/statistics.h"

namespace meshalyzer {
namespace {

SchemaObject report_object() {
  return {.description =
              "A report of meshalyzer. Every real is the shortest decimal that "
              "reads back the same; null is undefined or not computed. A program may "
              "rely on these keys; more may be added. Definitions: doc/definitions.md.",
          .members = {{"version", "", schema_type::kText},
                      {"meshes", "in the order of the command line, those of a folder by name",
                       R"("type": "array", "items": {"$ref": "#/$defs/mesh"})"},
                      {"unreadable", "files that cannot be read, and why; only where there are any",
                       R"("type": "array", "items": {"$ref": "#/$defs/unreadable"})",
                       SchemaMember::Presence::Sometimes},
                      {"set", "only for a set: a folder, or several files with -i or -s",
                       schema_reference("set"), SchemaMember::Presence::Sometimes}}};
}

void define_unreadable(SchemaDefinitions& schema) {
  SchemaObject file{.description = "", .members = path_members()};
  file.members.push_back({"error", "FILE:LINE: what is wrong", schema_type::kText});
  file.members.push_back(
      {"error_bytes", "as path_bytes", schema_type::kText, SchemaMember::Presence::Sometimes});
  schema.define("unreadable", file);
}

}  // namespace

std::string json_schema() {
  return schema_document(kReportSchema, report_object(), [](SchemaDefinitions& definitions) {
    define_mesh(definitions);
    define_unreadable(definitions);
    define_curvature(definitions);
    define_offenders(definitions);
    define_set(definitions);
    define_statistics(definitions);
    define_non_finite(definitions);
    define_points(definitions);
  });
}

}  // namespace meshalyzer
