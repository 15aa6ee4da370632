#include "meshalyzer/report/json/offenders.h"

#include "meshalyzer/analysis/field_info.h"
#include "meshalyzer/analysis/offender_lists.h"
#include "meshalyzer/report/json/elements.h"

#include <limits>
#include <span>
#include <tuple>

namespace meshalyzer {
namespace {

// Lists of numbers that are no records: missing ids, lines.

void write_list(JsonWriter& json, const Analysis& /*analysis*/,
                const std::vector<std::int64_t>& list, Ids Analysis::* /*ids*/) {
  json.array(list);
}

void read_list(const JsonNode& node, std::vector<std::int64_t>& list) {
  for (JsonElements elements = node.elements(); !elements.at_end();) {
    list.push_back(elements.next().integer());
  }
}

// Lists of vertices or faces.

void write_list(JsonWriter& json, const Analysis& analysis, const std::vector<Index>& list,
                Ids Analysis::*ids) {
  json.begin_array(JsonLayout::Row);
  for (const Index record : list) {
    json.value((analysis.*ids).of(record));
  }
  json.end_array();
}

void read_list(const JsonNode& node, std::vector<Index>& list) {
  for (JsonElements elements = node.elements(); !elements.at_end();) {
    list.push_back(read_id(elements.next()));
  }
}

// Lists of edges, with or without measured values.

/// Returns a measured value. The writer has null for an infinite one (NaN exceeds no threshold, and
/// no measured value is negative).
double read_measured(const JsonNode& node) {
  return node.is_null() ? std::numeric_limits<double>::infinity() : node.real();
}

void write_list(JsonWriter& json, const Analysis& analysis, const EdgeList& list,
                Ids Analysis::* /*ids*/) {
  json.begin_array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    json.begin_array(JsonLayout::Row);
    json.value(analysis.vertex_ids.of(list.ends[i][0]));
    json.value(analysis.vertex_ids.of(list.ends[i][1]));
    json.begin_array(JsonLayout::Row);
    for (Index k = list.begin[i]; k < list.begin[i + 1]; ++k) {
      json.value(analysis.face_ids.of(list.faces[k]));
    }
    json.end_array();
    if (!list.values.empty()) {
      json.value(list.values[i]);
    }
    json.end_array();
  }
  json.end_array();
}

enum class EdgeValues { Absent, Present };

void read_edge(const JsonNode& edge, EdgeValues values, EdgeList& list) {
  JsonElements parts = edge.elements();
  const Index a = read_id(parts.next());
  const Index b = read_id(parts.next());
  list.ends.push_back({a, b});
  read_list(parts.next(), list.faces);
  list.begin.push_back(static_cast<Index>(list.faces.size()));
  if (values == EdgeValues::Present) {
    list.values.push_back(read_measured(parts.next()));
  }
  parts.expect_end();
}

void read_edges(const JsonNode& node, EdgeValues values, EdgeList& list) {
  for (JsonElements edges = node.elements(); !edges.at_end();) {
    read_edge(edges.next(), values, list);
  }
}

void read_list(const JsonNode& node, EdgeList& list) {
  read_edges(node, EdgeValues::Absent, list);
}

void read_list(const JsonNode& node, std::optional<EdgeList>& list) {
  read_edges(node, EdgeValues::Present, list.emplace());
}

// Lists of measured faces.

void write_list(JsonWriter& json, const Analysis& analysis, const FaceList& list,
                Ids Analysis::* /*ids*/) {
  json.begin_array();
  for (std::size_t i = 0; i < list.faces.size(); ++i) {
    json.begin_array(JsonLayout::Row);
    json.value(analysis.face_ids.of(list.faces[i]));
    json.value(list.values[i]);
    json.end_array();
  }
  json.end_array();
}

void read_list(const JsonNode& node, std::optional<FaceList>& list) {
  list.emplace();
  for (JsonElements faces = node.elements(); !faces.at_end();) {
    JsonElements parts = faces.next().elements();
    list->faces.push_back(read_id(parts.next()));
    list->values.push_back(read_measured(parts.next()));
    parts.expect_end();
  }
}

// Lists of pairs of faces.

void write_list(JsonWriter& json, const Analysis& analysis,
                const std::vector<IntersectingPair>& list, Ids Analysis::* /*ids*/) {
  json.begin_array();
  for (const IntersectingPair& pair : list) {
    json.begin_array(JsonLayout::Row);
    json.value(analysis.face_ids.of(pair.face_a));
    json.value(analysis.face_ids.of(pair.face_b));
    json.value(contact_name(pair.kind));
    json.end_array();
  }
  json.end_array();
}

void read_list(const JsonNode& node, std::vector<IntersectingPair>& list) {
  for (JsonElements elements = node.elements(); !elements.at_end();) {
    JsonElements parts = elements.next().elements();
    const Index a = read_id(parts.next());
    const Index b = read_id(parts.next());
    list.push_back({a, b, read_contact(parts.next())});
    parts.expect_end();
  }
}

// The breaks of the numbering.

void write_list(JsonWriter& json, const Analysis& /*analysis*/,
                const std::optional<NumberingBreak>& place, Ids Analysis::* /*ids*/) {
  if (place) {
    write_numbering(json, *place);
  } else {
    json.null();
  }
}

void read_list(const JsonNode& node, std::optional<NumberingBreak>& place) {
  if (!node.is_null()) {
    place = read_numbering(node);
  }
}

template <typename Rows>
void write_lists(JsonWriter& json, const Analysis& analysis, const Rows& rows) {
  for_each_row(rows, [&](const auto& row) {
    json.key(row.info.key);
    write_list(json, analysis, analysis.offenders.*row.member, row.ids);
  });
}

void write_asked_lists(JsonWriter& json, const Analysis& analysis) {
  for_each_row(kRequestedLists, [&](const auto& row) {
    if (const auto& list = analysis.offenders.*row.member) {
      json.key(row.info.key);
      write_list(json, analysis, *list, row.ids);
    }
  });
}

constexpr std::string_view kUnlistedPairsKey = "intersecting_pairs_unlisted";

void write_unlisted_pairs(JsonWriter& json, const Analysis& analysis) {
  const std::size_t n_listed = analysis.offenders.intersecting_pairs.size();
  if (const std::size_t n = analysis.characteristics.intersecting_pairs; n > n_listed) {
    json.member(kUnlistedPairsKey, n - n_listed);
  }
}

// The names of the lists in the schema.
constexpr std::string_view type_name(const std::vector<std::int64_t>& /*list*/) {
  return "ids";
}
constexpr std::string_view type_name(const std::vector<Index>& /*list*/) {
  return "ids";
}
constexpr std::string_view type_name(const EdgeList& /*list*/) {
  return "edges";
}
constexpr std::string_view type_name(const std::vector<IntersectingPair>& /*list*/) {
  return "face_pairs";
}
constexpr std::string_view type_name(const std::optional<NumberingBreak>& /*place*/) {
  return "numbering";
}
constexpr std::string_view type_name(const std::optional<EdgeList>& /*list*/) {
  return "measured_edges";
}
constexpr std::string_view type_name(const std::optional<FaceList>& /*list*/) {
  return "measured_faces";
}

/// Returns an array of rows of n places.
std::string rows_type(std::size_t n, std::string_view places) {
  const std::string size = std::to_string(n);
  return R"("type": "array", "items": {"type": "array", "minItems": )" + size +
         R"(, "maxItems": )" + size + R"(, "prefixItems": [)" + std::string(places) + "]}";
}

void define_rows(SchemaDefinitions& schema) {
  schema.define(
      "edges", "two vertex ids, all faces",
      rows_type(3, R"({"type": "integer"}, {"type": "integer"}, {"$ref": "#/$defs/ids"})"));
  schema.define("measured_edges", "two vertex ids, all faces, the measured value (null: infinite)",
                rows_type(4, R"({"type": "integer"}, {"type": "integer"}, )"
                             R"({"$ref": "#/$defs/ids"}, {"type": ["number", "null"]})"));
  schema.define("measured_faces", "face id, the measured value (null: infinite)",
                rows_type(2, R"({"type": "integer"}, {"type": ["number", "null"]})"));
  schema.define("face_pairs", "two face ids, how they meet",
                rows_type(3, R"({"type": "integer"}, {"type": "integer"}, )"
                             R"({"$ref": "#/$defs/contact"})"));
}

/// The lists that every analysis has.
constexpr auto kLists =
    std::tuple_cat(kTornLineLists, kRecordLists, kNumberingBreaks, kAttributeLists);

/// The rows of all tables.
constexpr auto kAllLists = std::tuple_cat(kLists, kMeasuredLists, kRequestedLists);

}  // namespace

void write_offenders(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders) {
  json.begin_object();
  if (offenders == JsonOffenders::List) {
    write_lists(json, analysis, kLists);
    // A list that was not computed must not look like an empty one.
    if (analysis.has_characteristics) {
      write_lists(json, analysis, kMeasuredLists);
      write_unlisted_pairs(json, analysis);
    }
  }
  write_asked_lists(json, analysis);
  json.end_object();
}

Offenders read_offenders(const JsonNode& object) {
  Offenders all;
  for_each_row(kAllLists, [&](const auto& row) {
    if (const std::optional<JsonNode> node = object.find(row.info.key)) {
      read_list(*node, all.*row.member);
    }
  });
  return all;
}

void define_offenders(SchemaDefinitions& schema) {
  define_elements(schema);
  define_rows(schema);
  SchemaObject object{.description =
                          "every element by its id in the file; lists that were not "
                          "computed have no key"};
  const Offenders none;
  for_each_row(kAllLists, [&](const auto& row) {
    object.members.push_back({.key = std::string(row.info.key),
                              .description = "",
                              .type = schema_reference(type_name(none.*row.member)),
                              .presence = SchemaMember::Presence::Sometimes});
  });
  object.members.push_back({.key = std::string(kUnlistedPairsKey),
                            .description = "how many pairs the list leaves out, where it is cut",
                            .type = schema_type::kCount,
                            .presence = SchemaMember::Presence::Sometimes});
  schema.define("offenders", object);
}

}  // namespace meshalyzer
