#include "meshalyzer/report/journal/line.h"
#include "meshalyzer/report/journal/line_kind.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/elements.h"
#include "meshalyzer/report/json/name.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/point.h"
#include "meshalyzer/report/json/tree.h"

#include <limits>
#include <unordered_map>

namespace meshalyzer {
namespace {

void require_kind(const JsonNode& line, LineHead::Kind kind) {
  const JsonNode node = line.member("kind");
  if (node.text() != kind_name(kind)) {
    node.refuse("another kind of line");
  }
}

/// Reads the rows that FindingsWriter wrote.
class FindingsReader {
 public:
  FindingsReader(const JsonNode& line, const std::vector<std::string>& names);

  [[nodiscard]] Index owner() const { return mesh(line_.member("name")); }
  [[nodiscard]] std::optional<SetIntersections> intersections() const;
  [[nodiscard]] std::optional<ObjectSeparation> separation() const;

 private:
  [[nodiscard]] Index mesh(const JsonNode& name) const;
  [[nodiscard]] std::vector<SetPair> pairs(const JsonNode& list) const;
  [[nodiscard]] std::vector<MeshMeeting> meetings(const JsonNode& list) const;
  [[nodiscard]] std::vector<ContainedMesh> contained(const JsonNode& list) const;
  void read_closest(JsonElements row, ObjectSeparation& separation) const;

  JsonNode line_;
  std::unordered_map<std::string_view, Index> numbers_;
};

FindingsReader::FindingsReader(const JsonNode& line, const std::vector<std::string>& names)
    : line_(line) {
  for (JsonElements rows = line.member("numbers").elements(); !rows.at_end();) {
    const JsonNode row = rows.next();
    JsonElements parts = row.elements();
    const std::string_view name = parts.next().text();
    const std::size_t number = parts.next().count();
    parts.expect_end();
    if (number >= names.size() || json_name(names[number]) != name) {
      row.refuse("not the name of this mesh of the set");
    }
    if (!numbers_.emplace(name, static_cast<Index>(number)).second) {
      row.refuse("the name of two meshes");
    }
  }
}

Index FindingsReader::mesh(const JsonNode& name) const {
  const auto found = numbers_.find(name.text());
  if (found == numbers_.end()) {
    name.refuse("no name of a mesh");
  }
  return found->second;
}

std::vector<SetPair> FindingsReader::pairs(const JsonNode& list) const {
  std::vector<SetPair> pairs;
  for (JsonElements rows = list.elements(); !rows.at_end();) {
    JsonElements parts = rows.next().elements();
    SetPair& pair = pairs.emplace_back();
    pair.mesh_a = mesh(parts.next());
    pair.face_a = parts.next().integer();
    pair.mesh_b = mesh(parts.next());
    pair.face_b = parts.next().integer();
    pair.kind = read_contact(parts.next());
    parts.expect_end();
  }
  return pairs;
}

std::vector<MeshMeeting> FindingsReader::meetings(const JsonNode& list) const {
  std::vector<MeshMeeting> meetings;
  for (JsonElements rows = list.elements(); !rows.at_end();) {
    JsonElements parts = rows.next().elements();
    MeshMeeting& meeting = meetings.emplace_back();
    meeting.mesh_a = mesh(parts.next());
    meeting.mesh_b = mesh(parts.next());
    for (const ContactKind kind : kContactKinds) meeting.pairs.add(kind, parts.next().count());
    parts.expect_end();
  }
  return meetings;
}

std::vector<ContainedMesh> FindingsReader::contained(const JsonNode& list) const {
  std::vector<ContainedMesh> meshes;
  for (JsonElements rows = list.elements(); !rows.at_end();) {
    JsonElements parts = rows.next().elements();
    ContainedMesh& pair = meshes.emplace_back();
    pair.inner = mesh(parts.next());
    pair.outer = mesh(parts.next());
    parts.expect_end();
  }
  return meshes;
}

std::optional<SetIntersections> FindingsReader::intersections() const {
  const JsonNode list = line_.member("intersecting_pairs");
  if (list.is_null()) {
    return std::nullopt;
  }
  SetIntersections found{.pairs = pairs(list),
                         .contained = contained(line_.member("contained")),
                         .partly_contained = contained(line_.member("partly_contained")),
                         .unlisted = {},
                         .is_search_stopped = line_.find("at_least").has_value()};
  if (const auto unlisted = line_.find("unlisted")) found.unlisted = meetings(*unlisted);
  return found;
}

void expect_null(const JsonNode& node) {
  if (!node.is_null()) {
    node.refuse("a value, but no mesh");
  }
}

void FindingsReader::read_closest(JsonElements row, ObjectSeparation& separation) const {
  separation.vertices.push_back(row.next().integer());
  const JsonNode distance = row.next();
  const JsonNode name = row.next();
  double& length = separation.distances.emplace_back(std::numeric_limits<double>::quiet_NaN());
  Index& object = separation.objects.emplace_back(kNoIndex);
  std::int64_t& face = separation.faces.emplace_back(0);
  Vec3& point = separation.points.emplace_back(Vec3::Zero());
  if (name.is_null()) {
    expect_null(distance);
    expect_null(row.next());
    expect_null(row.next());
  } else {
    object = mesh(name);
    face = row.next().integer();
    const JsonNode place = row.next();
    if (row.at_end()) {
      length = distance.real();
      point = read_point(place);
    } else {
      const JsonNode reals = row.next();
      length = read_real(reals, "distance");
      point = {read_real(reals, "x"), read_real(reals, "y"), read_real(reals, "z")};
    }
  }
  row.expect_end();
}

std::optional<ObjectSeparation> FindingsReader::separation() const {
  const JsonNode list = line_.member("closest");
  if (list.is_null()) {
    return std::nullopt;
  }
  ObjectSeparation separation;
  for (JsonElements rows = list.elements(); !rows.at_end();) {
    read_closest(rows.next().elements(), separation);
  }
  return separation;
}

}  // namespace

std::string read_unreadable(std::string_view line) {
  const JsonTree tree(line);
  require_kind(tree.root(), LineHead::Kind::Unreadable);
  return read_bytes(tree.root(), "error");
}

ObjectFindings read_between(std::string_view line, const std::vector<std::string>& names) {
  const JsonTree tree(line);
  require_kind(tree.root(), LineHead::Kind::Between);
  const FindingsReader reader(tree.root(), names);
  return {.owner = reader.owner(),
          .intersections = reader.intersections(),
          .separation = reader.separation()};
}

}  // namespace meshalyzer
