#include "meshalyzer/report/text/sections.h"

#include "meshalyzer/analysis/fields.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/text/offenders.h"

#include <fmt/format.h>
#include <optional>
#include <string>

namespace meshalyzer {
namespace {

template <typename T>
void append_measure(LineSink& lines, std::string_view name, const Measure<T>& measure) {
  if (measure.value) {
    lines.line(name, *measure.value);
  } else {
    lines.line(name, undefined(measure.reason));
  }
}

void append_numbering(LineSink& lines, std::string_view name, bool contiguous,
                      const std::optional<NumberingBreak>& place) {
  if (contiguous || !place) {
    lines.line(name, contiguous);
  } else {
    lines.line(name, fmt::format("no (first offender in brackets: {})", numbering_text(*place)));
  }
}

void append_integrity_field(LineSink& lines, const FieldRow<Integrity, std::size_t>& row,
                            const Analysis& analysis) {
  const std::size_t count = analysis.integrity.*row.member;
  if (row.member != &Integrity::torn_lines) {
    lines.line(row.info.label, count);
  } else if (count > 0) {
    lines.line(row.info.label, fmt::format("{} (without Vertex or Face, skipped; first: line {})",
                                           count, analysis.offenders.torn_lines.front()));
  }
}

void append_integrity_field(LineSink& lines, const FieldRow<Integrity, bool>& row,
                            const Analysis& analysis) {
  append_numbering(lines, row.info.label, analysis.integrity.*row.member,
                   row.member == &Integrity::contiguous_vertices
                       ? analysis.offenders.vertex_numbering
                       : analysis.offenders.face_numbering);
}

std::string pairs_text(const Characteristics& c) {
  return c.is_search_stopped
             ? fmt::format(
                   "at least {} (of these unwelded: {}; the search ended at its time limit)",
                   c.intersecting_pairs, c.unwelded_pairs)
             : fmt::format("{} (of these unwelded: {})", c.intersecting_pairs, c.unwelded_pairs);
}

void append_count(LineSink& lines, const FieldRow<Characteristics, std::size_t>& row,
                  const Characteristics& c) {
  if (row.member == &Characteristics::intersecting_pairs) {
    lines.line(row.info.label, pairs_text(c));
  } else if (row.member == &Characteristics::intersecting_faces) {
    lines.count(row.info.label, c.intersecting_faces, c.is_search_stopped);
  } else if (!row.info.label.empty()) {
    lines.line(row.info.label, c.*row.member);
  }
}

/// Appends nothing for a field that is no count, which append_extent() handles.
template <typename T>
void append_count(LineSink& /*lines*/, const FieldRow<Characteristics, T>& /*row*/,
                  const Characteristics& /*c*/) {}

std::string point_text(const Vec3& point) {
  return fmt::format("{} {} {}", readable(point.x()), readable(point.y()), readable(point.z()));
}

std::string genus_text(const Characteristics& c) {
  if (!c.genus.value) {
    const std::string of_components =
        c.genus_of_components ? fmt::format("; of the components: {}", *c.genus_of_components) : "";
    return undefined(c.genus.reason + of_components);
  }
  return c.components < 2
             ? fmt::format("{}", *c.genus.value)
             : fmt::format("{} (the sum of {} components)", *c.genus.value, c.components);
}

}  // namespace

void append_integrity(LineSink& lines, const Analysis& analysis) {
  lines.line("file", analysis.path);
  lines.line("format", format_text(analysis.path, analysis.format));
  if (analysis.format == Format::Stl) {
    lines.line("merged points",
               fmt::format("{} (bit-identical points of the STL file count as one vertex)",
                           analysis.n_merged_points));
  }
  if (analysis.n_polygons > 0) {
    lines.line("polygons", fmt::format("{} (each fanned into triangles from its first corner)",
                                       analysis.n_polygons));
  }
  for_each_row(kIntegrityFields,
               [&](const auto& row) { append_integrity_field(lines, row, analysis); });
}

void append_attributes(LineSink& lines, const Attributes& attributes) {
  for_each_row(kAttributeFields, [&](const auto& row) {
    append_measure(lines, row.info.label, attributes.*row.member);
  });
}

void append_counts(LineSink& lines, const Characteristics& c) {
  for_each_row(kCharacteristicFields, [&](const auto& row) { append_count(lines, row, c); });
}

void append_extent(LineSink& lines, const Characteristics& c) {
  if (c.bounding_box.isEmpty()) {
    lines.line("bounding box", "undefined (no face)");
  } else {
    lines.line("bounding box min", point_text(c.bounding_box.min()));
    lines.line("bounding box max", point_text(c.bounding_box.max()));
  }
  lines.line("area", c.area);
  append_measure(lines, "volume", c.volume);
  lines.line("genus", genus_text(c));
}

}  // namespace meshalyzer
