#include "meshalyzer/report/text/offenders.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/asked_lists.h"

#include <span>

namespace meshalyzer {
namespace {

/// The names of a list and of each element in it.
struct ListName {
  std::string_view list;
  std::string_view element;
  /// Before and after the measured value of an element, where it has one.
  std::string_view quantity = {};
  std::string_view unit = {};
};

class OffenderLines {
 public:
  OffenderLines(TextLines& lines, const Analysis& analysis, OffenderStyle style)
      : lines_(lines),
        text_(lines.text()),
        analysis_(analysis),
        points_(style == OffenderStyle::CustomPoints) {}

  void vertices(const ListName& name, std::span<const Index> list);
  void faces(const ListName& name, std::span<const Index> list);
  void edges(const ListName& name, const EdgeList& list);
  void pairs(const ListName& name, std::span<const IntersectingPair> list);
  /// Adds a list of numbers that are no records: of ids that are missing, or of lines.
  void numbers(const ListName& name, std::span<const std::int64_t> numbers);
  void numbering(std::string_view name, const std::optional<NumberingBreak>& place);
  /// Adds a list that was asked for by a threshold: it is told even where it is empty.
  void asked(const ListName& name, const std::optional<EdgeList>& list);
  void asked(const ListName& name, const std::optional<FaceList>& list);

 private:
  void head(const ListName& name, std::size_t size) { lines_.line(name.list, size); }
  void integer(std::int64_t number);
  /// An element without a value is `name id`, ended by the caller.
  void element(const ListName& name, std::int64_t id);
  void edge_line(const ListName& name, const EdgeList& list, std::size_t i);
  void edge_list(const ListName& name, const EdgeList& list);
  void point(Index vertex);
  void points_of_face(Index face);

  TextLines& lines_;
  std::string& text_;
  const Analysis& analysis_;
  bool points_;
};

void OffenderLines::integer(std::int64_t number) {
  text_ += std::to_string(number);
}

void OffenderLines::element(const ListName& name, std::int64_t id) {
  text_ += name.element;
  text_ += ' ';
  integer(id);
}

/// DReAMM's custom point: a place and the direction of its glyph.
void OffenderLines::point(Index vertex) {
  if (vertex == kNoIndex) {
    return;  // a corner that no record defines has no place
  }
  const Vec3& position = analysis_.soup->positions[vertex];
  for (const double coordinate : {position.x(), position.y(), position.z()}) {
    append_shortest(text_, coordinate);
    text_ += ' ';
  }
  text_ += "1 0 0 1\n";
}

void OffenderLines::points_of_face(Index face) {
  for (const Index vertex : analysis_.soup->triangles[face]) {
    point(vertex);
  }
}

void OffenderLines::vertices(const ListName& name, std::span<const Index> list) {
  if (list.empty()) {
    return;
  }
  head(name, list.size());
  for (const Index vertex : list) {
    if (points_) {
      point(vertex);
    } else {
      element(name, analysis_.vertex_ids.of(vertex));
      text_ += '\n';
    }
  }
}

void OffenderLines::faces(const ListName& name, std::span<const Index> list) {
  if (list.empty()) {
    return;
  }
  head(name, list.size());
  for (const Index face : list) {
    if (points_) {
      points_of_face(face);
    } else {
      element(name, analysis_.face_ids.of(face));
      text_ += '\n';
    }
  }
}

void OffenderLines::edge_line(const ListName& name, const EdgeList& list, std::size_t i) {
  element(name, analysis_.vertex_ids.of(list.ends[i][0]));
  text_ += ' ';
  integer(analysis_.vertex_ids.of(list.ends[i][1]));
  text_ += ':';
  if (!list.values.empty()) {
    text_ += ' ';
    text_ += name.quantity;
    text_ += readable(list.values[i]);
    text_ += name.unit;
    text_ += ',';
  }
  text_ += list.begin[i + 1] - list.begin[i] == 1 ? " face" : " faces";
  for (Index k = list.begin[i]; k < list.begin[i + 1]; ++k) {
    text_ += ' ';
    integer(analysis_.face_ids.of(list.faces[k]));
  }
  text_ += '\n';
}

void OffenderLines::edge_list(const ListName& name, const EdgeList& list) {
  head(name, list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (points_) {
      point(list.ends[i][0]);
      point(list.ends[i][1]);
    } else {
      edge_line(name, list, i);
    }
  }
}

void OffenderLines::edges(const ListName& name, const EdgeList& list) {
  if (list.size() > 0) {
    edge_list(name, list);
  }
}

void OffenderLines::pairs(const ListName& name, std::span<const IntersectingPair> list) {
  if (list.empty()) {
    return;
  }
  head(name, list.size());
  for (const IntersectingPair& pair : list) {
    if (points_) {
      points_of_face(pair.face_a);
      points_of_face(pair.face_b);
      continue;
    }
    element(name, analysis_.face_ids.of(pair.face_a));
    text_ += ' ';
    integer(analysis_.face_ids.of(pair.face_b));
    text_ += ": ";
    text_ += contact_name(pair.kind);
    text_ += '\n';
  }
}

void OffenderLines::numbers(const ListName& name, std::span<const std::int64_t> numbers) {
  if (numbers.empty()) {
    return;
  }
  head(name, numbers.size());
  for (const std::int64_t number : numbers) {
    element(name, number);
    text_ += '\n';
  }
}

void OffenderLines::numbering(std::string_view name, const std::optional<NumberingBreak>& place) {
  if (place) {
    lines_.line(name, numbering_text(*place));
  }
}

void OffenderLines::asked(const ListName& name, const std::optional<EdgeList>& list) {
  if (list) {
    edge_list(name, *list);
  }
}

void OffenderLines::asked(const ListName& name, const std::optional<FaceList>& list) {
  if (!list) {
    return;
  }
  head(name, list->faces.size());
  for (std::size_t i = 0; i < list->faces.size(); ++i) {
    if (points_) {
      points_of_face(list->faces[i]);
    } else {
      element(name, analysis_.face_ids.of(list->faces[i]));
      text_ += ": ";
      text_ += readable(list->values[i]);
      text_ += '\n';
    }
  }
}

void append_integrity(OffenderLines& lines, const Offenders& all) {
  lines.vertices({"offending orphan vertices", "orphan vertex"}, all.orphan_vertices);
  lines.numbers({"offending missing vertices", "missing vertex"}, all.missing_vertices);
  lines.faces({"offending faces with missing vertices", "face with missing vertex"},
              all.faces_with_missing_vertices);
  lines.faces({"offending degenerate faces", "degenerate face"}, all.degenerate_faces);
  lines.vertices({"offending duplicate vertex indices", "duplicate vertex index"},
                 all.duplicate_vertex_records);
  lines.faces({"offending duplicate face indices", "duplicate face index"},
              all.duplicate_face_records);
  lines.numbers({"offending torn lines", "torn line"}, all.torn_lines);
  lines.numbering("offending vertex numbering", all.vertex_numbering);
  lines.numbering("offending face numbering", all.face_numbering);
}

void append_attributes(OffenderLines& lines, const Offenders& all) {
  lines.edges({"offending border edges", "border edge"}, all.border_edges);
  lines.edges({"offending non-manifold edges", "non-manifold edge"}, all.non_manifold_edges);
  lines.vertices({"offending non-manifold vertices", "non-manifold vertex"},
                 all.non_manifold_vertices);
  lines.vertices({"offending pinched vertices", "pinched vertex"}, all.pinched_vertices);
  lines.edges({"offending flipped edges", "flipped edge"}, all.flipped_edges);
}

void append_characteristics(OffenderLines& lines, const Offenders& all) {
  lines.vertices({"offending indistinguishable vertices", "indistinguishable vertex"},
                 all.indistinguishable_vertices);
  lines.edges({"offending indistinguishable edges", "indistinguishable edge"},
              all.indistinguishable_edges);
  lines.faces({"offending zero-area faces", "zero-area face"}, all.zero_area_faces);
  lines.faces({"offending duplicate faces", "duplicate face"}, all.duplicate_faces);
  lines.pairs({"offending intersecting pairs", "intersecting faces"}, all.intersecting_pairs);
}

void append_asked(OffenderLines& lines, const Offenders& all) {
  lines.asked({"short edges", "short edge", "length "}, all.short_edges);
  lines.asked({"long edges", "long edge", "length "}, all.long_edges);
  lines.asked({"small edge angles", "small edge angle", "", " degrees"}, all.small_angles);
  lines.asked({"large edge angles", "large edge angle", "", " degrees"}, all.large_angles);
  lines.asked({"large aspect ratios", "large aspect ratio of face"}, all.large_aspect_ratios);
}

}  // namespace

std::string numbering_text(const NumberingBreak& place) {
  std::string text;
  for (std::size_t i = 0; i < place.ids.size(); ++i) {
    const bool is_offender = i == place.offender;
    text += i == 0 ? "" : " ";
    text += is_offender ? "[" : "";
    text += std::to_string(place.ids[i]);
    text += is_offender ? "]" : "";
  }
  return text;
}

void append_offenders(TextLines& lines, const Analysis& analysis, OffenderStyle style) {
  const Offenders& all = analysis.offenders;
  if (style == OffenderStyle::None && !has_asked_lists(all)) {
    return;
  }
  if (!analysis.soup && style == OffenderStyle::CustomPoints) {
    style = OffenderStyle::Ids;
  }
  lines.heading("OFFENDING ELEMENTS");
  const std::size_t length_before = lines.text().size();
  OffenderLines offenders(lines, analysis, style);
  if (style != OffenderStyle::None) {
    if (analysis.has_characteristics) {
      append_integrity(offenders, all);
    }
    append_attributes(offenders, all);
    if (analysis.has_characteristics) {
      append_characteristics(offenders, all);
    }
  }
  append_asked(offenders, all);
  if (lines.text().size() == length_before) {
    lines.line("offending elements", "none");
  }
}

}  // namespace meshalyzer
