#include "meshalyzer/report/json/offenders_reader.h"

#include "meshalyzer/report/json/record_ids.h"

#include <algorithm>
#include <array>
#include <limits>

namespace meshalyzer {
namespace {

enum class EdgeValues { Absent, Present };

/// A measured value; the writer has null for an infinite one (NaN compares with no threshold, and
/// nothing that is measured is negative).
double read_value(const JsonNode& node) {
  return node.is_null() ? std::numeric_limits<double>::infinity() : node.real();
}

void read_edge(const JsonNode& edge, EdgeValues values, EdgeList& list) {
  JsonElements parts = edge.elements();
  const Index a = read_id(parts.next());
  const Index b = read_id(parts.next());
  list.ends.push_back({a, b});
  for (JsonElements faces = parts.next().elements(); !faces.at_end();) {
    list.faces.push_back(read_id(faces.next()));
  }
  list.begin.push_back(static_cast<Index>(list.faces.size()));
  if (values == EdgeValues::Present) {
    list.values.push_back(read_value(parts.next()));
  }
  parts.expect_end();
}

EdgeList read_edges(const JsonNode& node, EdgeValues values) {
  EdgeList list;
  for (JsonElements edges = node.elements(); !edges.at_end();) {
    read_edge(edges.next(), values, list);
  }
  return list;
}

FaceList read_faces(const JsonNode& node) {
  FaceList list;
  for (JsonElements faces = node.elements(); !faces.at_end();) {
    JsonElements parts = faces.next().elements();
    list.faces.push_back(read_id(parts.next()));
    list.values.push_back(read_value(parts.next()));
    parts.expect_end();
  }
  return list;
}

std::vector<IntersectingPair> read_pairs(const JsonNode& node) {
  std::vector<IntersectingPair> pairs;
  for (JsonElements elements = node.elements(); !elements.at_end();) {
    JsonElements parts = elements.next().elements();
    const Index a = read_id(parts.next());
    const Index b = read_id(parts.next());
    pairs.push_back({a, b, read_contact(parts.next())});
    parts.expect_end();
  }
  return pairs;
}

std::vector<Index> read_ids(const JsonNode& node) {
  std::vector<Index> ids;
  for (JsonElements elements = node.elements(); !elements.at_end();) {
    ids.push_back(read_id(elements.next()));
  }
  return ids;
}

std::vector<std::int64_t> read_integers(const JsonNode& node) {
  std::vector<std::int64_t> integers;
  for (JsonElements elements = node.elements(); !elements.at_end();) {
    integers.push_back(elements.next().integer());
  }
  return integers;
}

/// Reads the lists that are there; the others keep what they hold.
class ListReader {
 public:
  explicit ListReader(const JsonNode& object) : object_(object) {}

  void records(std::string_view name, std::vector<Index>& list) const {
    read(name, [&](const JsonNode& node) { list = read_ids(node); });
  }
  void integers(std::string_view name, std::vector<std::int64_t>& list) const {
    read(name, [&](const JsonNode& node) { list = read_integers(node); });
  }
  void edges(std::string_view name, EdgeList& list) const {
    read(name, [&](const JsonNode& node) { list = read_edges(node, EdgeValues::Absent); });
  }
  void pairs(std::string_view name, std::vector<IntersectingPair>& list) const {
    read(name, [&](const JsonNode& node) { list = read_pairs(node); });
  }
  void asked(std::string_view name, std::optional<EdgeList>& list) const {
    read(name, [&](const JsonNode& node) { list = read_edges(node, EdgeValues::Present); });
  }
  void asked(std::string_view name, std::optional<FaceList>& list) const {
    read(name, [&](const JsonNode& node) { list = read_faces(node); });
  }

 private:
  template <typename Read>
  void read(std::string_view name, const Read& read) const {
    if (const std::optional<JsonNode> node = object_.find(name)) {
      read(*node);
    }
  }

  JsonNode object_;
};

}  // namespace

Offenders read_offenders(const JsonNode& object) {
  const ListReader lists(object);
  Offenders all;
  lists.integers("torn_lines", all.torn_lines);
  lists.records("orphan_vertices", all.orphan_vertices);
  lists.integers("missing_vertices", all.missing_vertices);
  lists.records("faces_with_missing_vertices", all.faces_with_missing_vertices);
  lists.records("degenerate_faces", all.degenerate_faces);
  lists.records("duplicate_vertex_indices", all.duplicate_vertex_records);
  lists.records("duplicate_face_indices", all.duplicate_face_records);
  lists.edges("border_edges", all.border_edges);
  lists.edges("non_manifold_edges", all.non_manifold_edges);
  lists.records("non_manifold_vertices", all.non_manifold_vertices);
  lists.records("pinched_vertices", all.pinched_vertices);
  lists.edges("flipped_edges", all.flipped_edges);
  lists.records("indistinguishable_vertices", all.indistinguishable_vertices);
  lists.edges("indistinguishable_edges", all.indistinguishable_edges);
  lists.records("zero_area_faces", all.zero_area_faces);
  lists.records("duplicate_faces", all.duplicate_faces);
  lists.pairs("intersecting_pairs", all.intersecting_pairs);
  lists.asked("short_edges", all.short_edges);
  lists.asked("long_edges", all.long_edges);
  lists.asked("small_angles", all.small_angles);
  lists.asked("large_angles", all.large_angles);
  lists.asked("large_aspect_ratios", all.large_aspect_ratios);
  return all;
}

ContactKind read_contact(const JsonNode& node) {
  const std::string_view name = node.text();
  for (const ContactKind kind :
       {ContactKind::Duplicate, ContactKind::Unwelded, ContactKind::FoldOver,
        ContactKind::CoplanarOverlap, ContactKind::Crossing, ContactKind::Touching}) {
    if (name == contact_name(kind)) {
      return kind;
    }
  }
  node.refuse("no kind of contact");
}

NumberingBreak read_numbering(const JsonNode& object) {
  return {read_integers(object.member("ids")), object.member("offender").count()};
}

Index read_id(const JsonNode& node) {
  const std::int64_t id = node.integer();
  if (id < std::numeric_limits<std::int32_t>::min() ||
      id > std::numeric_limits<std::int32_t>::max()) {
    node.refuse("no id: beyond 32 bits");
  }
  return id_in_place_of_record(static_cast<std::int32_t>(id));
}

}  // namespace meshalyzer
