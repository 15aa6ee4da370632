#include "meshalyzer/report/journal/line.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/report/journal/line_kind.h"
#include "meshalyzer/report/journal/request.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/findings.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/name.h"

#include <algorithm>
#include <iterator>

namespace meshalyzer {
namespace {

void write_head(JsonWriter& json, const LineHead& head, LineHead::Kind kind) {
  json.member("number", head.number);
  json.member("of", head.of);
  json.member("kind", kind_name(kind));
  json.member("bytes", head.stamp.bytes);
  json.member("modified", head.stamp.modified_ns);
  json.key("asked");
  write_request(json, head.request);
  json.member("set", head.set);
}

/// Returns the meshes that the rows name, each once, ascending.
std::vector<Index> meshes_in(const ObjectFindings& findings) {
  std::vector<Index> meshes{findings.owner};
  if (findings.intersections) {
    for (const MeshMeeting& meeting : meetings_of(*findings.intersections)) {
      meshes.insert(meshes.end(), {meeting.mesh_a, meeting.mesh_b});
    }
    for (const auto* list :
         {&findings.intersections->contained, &findings.intersections->partly_contained}) {
      for (const ContainedMesh& mesh : *list) {
        meshes.insert(meshes.end(), {mesh.inner, mesh.outer});
      }
    }
  }
  if (findings.separation) {
    std::copy_if(findings.separation->objects.begin(), findings.separation->objects.end(),
                 std::back_inserter(meshes), [](Index mesh) { return mesh != kNoIndex; });
  }
  sort_unique(meshes);
  return meshes;
}

void write_numbers(JsonWriter& json, const ObjectFindings& findings,
                   const std::vector<std::string>& names) {
  json.key("numbers");
  json.begin_array();
  for (const Index mesh : meshes_in(findings)) {
    json.begin_array();
    json.value(json_name(names[mesh]));
    json.value(mesh);
    json.end_array();
  }
  json.end_array();
}

/// Writes a member, with the value null if `maybe` is empty, else with the value that `write`
/// writes.
template <typename T, typename Write>
void write_member(JsonWriter& json, std::string_view name, const std::optional<T>& maybe,
                  const Write& write) {
  json.key(name);
  if (maybe) {
    write(*maybe);
  } else {
    json.null();
  }
}

}  // namespace

std::string mesh_line(const LineHead& head, const Analysis& analysis, JsonOffenders offenders) {
  JsonWriter json;
  json.begin_object(JsonLayout::Row);
  write_head(json, head, LineHead::Kind::Mesh);
  write_mesh_members(json, analysis, offenders);
  json.end_object();
  return json.take();
}

std::string unreadable_line(const LineHead& head, std::string_view why) {
  JsonWriter json;
  json.begin_object(JsonLayout::Row);
  write_head(json, head, LineHead::Kind::Unreadable);
  write_bytes(json, "path", head.path);
  write_bytes(json, "error", why);
  json.end_object();
  return json.take();
}

std::string between_line(const LineHead& head, const ObjectFindings& findings,
                         const std::vector<std::string>& names) {
  JsonWriter json;
  json.begin_object(JsonLayout::Row);
  write_head(json, head, LineHead::Kind::Between);
  write_bytes(json, "path", head.path);
  json.member("name", json_name(names[findings.owner]));
  write_numbers(json, findings, names);
  FindingsWriter rows(json, names, [] {});
  write_member(json, "intersecting_pairs", findings.intersections,
               [&](const SetIntersections& found) { rows.pairs(found.pairs); });
  if (findings.intersections) rows.bounds(*findings.intersections);
  write_member(json, "contained", findings.intersections,
               [&](const SetIntersections& found) { rows.contained(found.contained); });
  write_member(json, "partly_contained", findings.intersections,
               [&](const SetIntersections& found) { rows.contained(found.partly_contained); });
  write_member(json, "closest", findings.separation,
               [&](const ObjectSeparation& separation) { rows.closest(separation); });
  json.end_object();
  return json.take();
}

}  // namespace meshalyzer
