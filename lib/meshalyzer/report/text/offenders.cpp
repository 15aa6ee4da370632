#include "meshalyzer/report/text/offenders.h"

#include "meshalyzer/analysis/field_info.h"
#include "meshalyzer/analysis/offender_lists.h"
#include "meshalyzer/base/numbers.h"

#include <fmt/format.h>
#include <string_view>

namespace meshalyzer {
namespace {

/// Writes lists of offenders, each with its size and then one line for each element or point.
class OffenderLines {
 public:
  OffenderLines(TextLines& lines, const Analysis& analysis, OffenderStyle style)
      : lines_(lines),
        text_(lines.text()),
        analysis_(analysis),
        points_(style == OffenderStyle::CustomPoints) {}

  template <typename Rows>
  void append(const Rows& rows) {
    for_each_row(rows, [this](const auto& row) { list(row, analysis_.offenders.*row.member); });
  }

 private:
  template <typename List>
  using Row = OffenderListRow<List>;

  /// Writes a list of vertices or faces.
  void list(const Row<std::vector<Index>>& row, const std::vector<Index>& records);
  void list(const Row<EdgeList>& row, const EdgeList& edges);
  void list(const Row<std::vector<IntersectingPair>>& row,
            const std::vector<IntersectingPair>& pairs);
  /// Writes a list of numbers that are no records: of missing ids, or of lines.
  void list(const Row<std::vector<std::int64_t>>& row, const std::vector<std::int64_t>& numbers);
  void list(const Row<std::optional<NumberingBreak>>& row,
            const std::optional<NumberingBreak>& place);
  /// Writes a list requested by a threshold, even if it is empty.
  void list(const Row<std::optional<EdgeList>>& row, const std::optional<EdgeList>& edges);
  void list(const Row<std::optional<FaceList>>& row, const std::optional<FaceList>& faces);

  void head_of_found(const OffenderListInfo& info, std::size_t size) {
    lines_.line(std::string("offending ").append(info.label), size);
  }
  void integer(std::int64_t number);
  /// Begins the line of an element; the caller ends it.
  void element(const OffenderListInfo& info, std::int64_t id);
  void edge_line(const OffenderListInfo& info, const EdgeList& edges, std::size_t i);
  void edge_lines(const OffenderListInfo& info, const EdgeList& edges);
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

void OffenderLines::element(const OffenderListInfo& info, std::int64_t id) {
  text_ += info.element;
  text_ += ' ';
  integer(id);
}

/// Appends a custom point of DReAMM: a position and the direction of its glyph.
void OffenderLines::point(Index vertex) {
  if (vertex == kNoIndex) {
    return;  // a corner that no record defines has no position
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

void OffenderLines::list(const Row<std::vector<Index>>& row, const std::vector<Index>& records) {
  if (records.empty()) {
    return;
  }
  head_of_found(row.info, records.size());
  const bool are_faces = row.ids == &Analysis::face_ids;
  for (const Index record : records) {
    if (!points_) {
      element(row.info, (analysis_.*row.ids).of(record));
      text_ += '\n';
    } else if (are_faces) {
      points_of_face(record);
    } else {
      point(record);
    }
  }
}

void OffenderLines::edge_line(const OffenderListInfo& info, const EdgeList& edges, std::size_t i) {
  element(info, analysis_.vertex_ids.of(edges.ends[i][0]));
  text_ += ' ';
  integer(analysis_.vertex_ids.of(edges.ends[i][1]));
  text_ += ':';
  if (!edges.values.empty()) {
    text_ += ' ';
    text_ += info.quantity;
    text_ += readable(edges.values[i]);
    text_ += info.unit;
    text_ += ',';
  }
  text_ += edges.begin[i + 1] - edges.begin[i] == 1 ? " face" : " faces";
  for (Index k = edges.begin[i]; k < edges.begin[i + 1]; ++k) {
    text_ += ' ';
    integer(analysis_.face_ids.of(edges.faces[k]));
  }
  text_ += '\n';
}

void OffenderLines::edge_lines(const OffenderListInfo& info, const EdgeList& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (points_) {
      point(edges.ends[i][0]);
      point(edges.ends[i][1]);
    } else {
      edge_line(info, edges, i);
    }
  }
}

void OffenderLines::list(const Row<EdgeList>& row, const EdgeList& edges) {
  if (edges.size() > 0) {
    head_of_found(row.info, edges.size());
    edge_lines(row.info, edges);
  }
}

void OffenderLines::list(const Row<std::vector<IntersectingPair>>& row,
                         const std::vector<IntersectingPair>& pairs) {
  if (pairs.empty()) {
    return;
  }
  const Characteristics& c = analysis_.characteristics;
  lines_.line(std::string("offending ").append(row.info.label),
              list_head(c.intersecting_pairs, pairs.size(), c.is_search_stopped));
  for (const IntersectingPair& pair : pairs) {
    if (points_) {
      points_of_face(pair.face_a);
      points_of_face(pair.face_b);
      continue;
    }
    element(row.info, analysis_.face_ids.of(pair.face_a));
    text_ += ' ';
    integer(analysis_.face_ids.of(pair.face_b));
    text_ += ": ";
    text_ += contact_name(pair.kind);
    text_ += '\n';
  }
}

void OffenderLines::list(const Row<std::vector<std::int64_t>>& row,
                         const std::vector<std::int64_t>& numbers) {
  if (numbers.empty()) {
    return;
  }
  head_of_found(row.info, numbers.size());
  for (const std::int64_t number : numbers) {
    element(row.info, number);
    text_ += '\n';
  }
}

void OffenderLines::list(const Row<std::optional<NumberingBreak>>& row,
                         const std::optional<NumberingBreak>& place) {
  if (place) {
    lines_.line(std::string("offending ").append(row.info.label), numbering_text(*place));
  }
}

void OffenderLines::list(const Row<std::optional<EdgeList>>& row,
                         const std::optional<EdgeList>& edges) {
  if (edges) {
    lines_.line(row.info.label, edges->size());
    edge_lines(row.info, *edges);
  }
}

void OffenderLines::list(const Row<std::optional<FaceList>>& row,
                         const std::optional<FaceList>& faces) {
  if (!faces) {
    return;
  }
  lines_.line(row.info.label, faces->faces.size());
  for (std::size_t i = 0; i < faces->faces.size(); ++i) {
    if (points_) {
      points_of_face(faces->faces[i]);
    } else {
      element(row.info, analysis_.face_ids.of(faces->faces[i]));
      text_ += ": ";
      text_ += readable(faces->values[i]);
      text_ += '\n';
    }
  }
}

void append_found(OffenderLines& lines, const Analysis& analysis) {
  if (analysis.has_characteristics) {
    lines.append(kRecordLists);
    lines.append(kTornLineLists);
    lines.append(kNumberingBreaks);
  }
  lines.append(kAttributeLists);
  if (analysis.has_characteristics) {
    lines.append(kMeasuredLists);
  }
}

}  // namespace

std::string list_head(std::size_t n, std::size_t n_listed, bool is_at_least) {
  const std::string_view bound = is_at_least ? "at least " : "";
  return n > n_listed ? fmt::format("{}{}, of which the first {} are listed", bound, n, n_listed)
                      : fmt::format("{}{}", bound, n_listed);
}

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
  if (style == OffenderStyle::None && !has_asked_lists(analysis.offenders)) {
    return;
  }
  if (!analysis.soup && style == OffenderStyle::CustomPoints) {
    style = OffenderStyle::Ids;
  }
  lines.heading("OFFENDING ELEMENTS");
  const std::size_t length_before = lines.text().size();
  OffenderLines offenders(lines, analysis, style);
  if (style != OffenderStyle::None) {
    append_found(offenders, analysis);
  }
  offenders.append(kRequestedLists);
  if (lines.text().size() == length_before) {
    lines.line("offending elements", "none");
  }
}

}  // namespace meshalyzer
