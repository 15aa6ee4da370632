#include "meshalyzer/report/json/offenders.h"

#include <span>

namespace meshalyzer {
namespace {

class OffenderWriter {
 public:
  OffenderWriter(JsonWriter& json, const Analysis& analysis) : json_(json), analysis_(analysis) {}

  void vertices(std::string_view name, std::span<const Index> list) {
    ids(name, list, analysis_.vertex_ids);
  }
  void faces(std::string_view name, std::span<const Index> list) {
    ids(name, list, analysis_.face_ids);
  }
  /// What is an id already.
  void file_ids(std::string_view name, std::span<const std::int64_t> list);
  void edges(std::string_view name, const EdgeList& list);
  /// Those that were asked for by a threshold; no key where not.
  void asked(std::string_view name, const std::optional<EdgeList>& list);
  void asked(std::string_view name, const std::optional<FaceList>& list);
  void pairs(std::string_view name, std::span<const IntersectingPair> list);
  void numbering(std::string_view name, const std::optional<NumberingBreak>& place);

 private:
  void ids(std::string_view name, std::span<const Index> list, const Ids& ids);

  JsonWriter& json_;
  const Analysis& analysis_;
};

void OffenderWriter::ids(std::string_view name, std::span<const Index> list, const Ids& ids) {
  json_.key(name);
  json_.begin_array(JsonLayout::Row);
  for (const Index record : list) {
    json_.value(ids.of(record));
  }
  json_.end_array();
}

void OffenderWriter::file_ids(std::string_view name, std::span<const std::int64_t> list) {
  json_.key(name);
  json_.begin_array(JsonLayout::Row);
  for (const std::int64_t id : list) {
    json_.value(id);
  }
  json_.end_array();
}

void OffenderWriter::edges(std::string_view name, const EdgeList& list) {
  json_.key(name);
  json_.begin_array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    json_.begin_array(JsonLayout::Row);
    json_.value(analysis_.vertex_ids.of(list.ends[i][0]));
    json_.value(analysis_.vertex_ids.of(list.ends[i][1]));
    json_.begin_array(JsonLayout::Row);
    for (Index k = list.begin[i]; k < list.begin[i + 1]; ++k) {
      json_.value(analysis_.face_ids.of(list.faces[k]));
    }
    json_.end_array();
    if (!list.values.empty()) {
      json_.value(list.values[i]);
    }
    json_.end_array();
  }
  json_.end_array();
}

void OffenderWriter::asked(std::string_view name, const std::optional<EdgeList>& list) {
  if (list) {
    edges(name, *list);
  }
}

void OffenderWriter::pairs(std::string_view name, std::span<const IntersectingPair> list) {
  json_.key(name);
  json_.begin_array();
  for (const IntersectingPair& pair : list) {
    json_.begin_array(JsonLayout::Row);
    json_.value(analysis_.face_ids.of(pair.face_a));
    json_.value(analysis_.face_ids.of(pair.face_b));
    json_.value(contact_name(pair.kind));
    json_.end_array();
  }
  json_.end_array();
}

void OffenderWriter::asked(std::string_view name, const std::optional<FaceList>& list) {
  if (!list) {
    return;
  }
  json_.key(name);
  json_.begin_array();
  for (std::size_t i = 0; i < list->faces.size(); ++i) {
    json_.begin_array(JsonLayout::Row);
    json_.value(analysis_.face_ids.of(list->faces[i]));
    json_.value(list->values[i]);
    json_.end_array();
  }
  json_.end_array();
}

void OffenderWriter::numbering(std::string_view name, const std::optional<NumberingBreak>& place) {
  json_.key(name);
  if (place) {
    write_numbering(json_, *place);
  } else {
    json_.null();
  }
}

void write_integrity(OffenderWriter& writer, const Offenders& all) {
  writer.file_ids("torn_lines", all.torn_lines);
  writer.vertices("orphan_vertices", all.orphan_vertices);
  writer.file_ids("missing_vertices", all.missing_vertices);
  writer.faces("faces_with_missing_vertices", all.faces_with_missing_vertices);
  writer.faces("degenerate_faces", all.degenerate_faces);
  writer.vertices("duplicate_vertex_indices", all.duplicate_vertex_records);
  writer.faces("duplicate_face_indices", all.duplicate_face_records);
  writer.numbering("vertex_numbering", all.vertex_numbering);
  writer.numbering("face_numbering", all.face_numbering);
}

void write_attributes(OffenderWriter& writer, const Offenders& all) {
  writer.edges("border_edges", all.border_edges);
  writer.edges("non_manifold_edges", all.non_manifold_edges);
  writer.vertices("non_manifold_vertices", all.non_manifold_vertices);
  writer.vertices("pinched_vertices", all.pinched_vertices);
  writer.edges("flipped_edges", all.flipped_edges);
}

void write_characteristics(OffenderWriter& writer, const Offenders& all) {
  writer.vertices("indistinguishable_vertices", all.indistinguishable_vertices);
  writer.edges("indistinguishable_edges", all.indistinguishable_edges);
  writer.faces("zero_area_faces", all.zero_area_faces);
  writer.faces("duplicate_faces", all.duplicate_faces);
  writer.pairs("intersecting_pairs", all.intersecting_pairs);
}

void write_asked(OffenderWriter& writer, const Offenders& all) {
  writer.asked("short_edges", all.short_edges);
  writer.asked("long_edges", all.long_edges);
  writer.asked("small_angles", all.small_angles);
  writer.asked("large_angles", all.large_angles);
  writer.asked("large_aspect_ratios", all.large_aspect_ratios);
}

}  // namespace

void write_numbering(JsonWriter& json, const NumberingBreak& place) {
  json.begin_object(JsonLayout::Row);
  json.key("ids");
  json.begin_array(JsonLayout::Row);
  for (const std::int64_t id : place.ids) {
    json.value(id);
  }
  json.end_array();
  json.member("offender", place.offender);
  json.end_object();
}

void write_offenders(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders) {
  OffenderWriter writer(json, analysis);
  json.begin_object();
  if (offenders == JsonOffenders::List) {
    write_integrity(writer, analysis.offenders);
    write_attributes(writer, analysis.offenders);
    // A list that nobody computed must not look like one without elements.
    if (analysis.has_characteristics) {
      write_characteristics(writer, analysis.offenders);
    }
  }
  write_asked(writer, analysis.offenders);
  json.end_object();
}

}  // namespace meshalyzer
