#include "meshalyzer/report/text/sections.h"

#include "meshalyzer/report/text/offenders.h"

#include <fmt/format.h>
#include <optional>
#include <string>

namespace meshalyzer {
namespace {

void append_answer(LineSink& lines, std::string_view name, const Answer& answer) {
  if (answer.value) {
    lines.line(name, *answer.value);
  } else {
    lines.line(name, undefined(answer.reason));
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
  const Integrity& integrity = analysis.integrity;
  lines.line("file", analysis.path);
  lines.line("format", format_name(analysis.format));
  if (analysis.format == Format::Stl) {
    lines.line("merged points",
               fmt::format("{} (bit-identical points of the STL file count as one vertex)",
                           analysis.n_merged_points));
  }
  if (analysis.n_polygons > 0) {
    lines.line("polygons", fmt::format("{} (each fanned into triangles from its first corner)",
                                       analysis.n_polygons));
  }
  lines.line("orphan vertices", integrity.orphan_vertices);
  lines.line("missing vertices", integrity.missing_vertices);
  lines.line("degenerate faces", integrity.degenerate_faces);
  lines.line("duplicate vertex indices", integrity.duplicate_vertex_indices);
  lines.line("duplicate face indices", integrity.duplicate_face_indices);
  if (integrity.torn_lines > 0) {
    lines.line("torn lines",
               fmt::format("{} (without Vertex or Face, skipped; first: line {})",
                           integrity.torn_lines, analysis.offenders.torn_lines.front()));
  }
  append_numbering(lines, "contiguous vertex numbering", integrity.contiguous_vertices,
                   analysis.offenders.vertex_numbering);
  append_numbering(lines, "contiguous face numbering", integrity.contiguous_faces,
                   analysis.offenders.face_numbering);
}

void append_attributes(LineSink& lines, const Attributes& attributes) {
  append_answer(lines, "closed", attributes.closed);
  append_answer(lines, "manifold", attributes.manifold);
  append_answer(lines, "orientable", attributes.orientable);
  append_answer(lines, "consistent", attributes.consistent);
  append_answer(lines, "outward", attributes.outward);
}

void append_counts(LineSink& lines, const Characteristics& c) {
  lines.line("vertices", c.vertices);
  lines.line("faces", c.faces);
  lines.line("edges", c.edges);
  lines.line("components", c.components);
  lines.line("edge components", c.edge_components);
  lines.line("boundaries", c.boundaries);
  lines.line("border edges", c.border_edges);
  lines.line("non-manifold edges", c.non_manifold_edges);
  lines.line("non-manifold vertices", c.non_manifold_vertices);
  lines.line("pinched vertices", c.pinched_vertices);
  lines.line("flipped edges", c.flipped_edges);
  lines.line("indistinguishable vertices", c.indistinguishable_vertices);
  lines.line("indistinguishable edges", c.indistinguishable_edges);
  lines.line("zero-area faces", c.zero_area_faces);
  lines.line("duplicate faces", c.duplicate_faces);
  lines.line("intersecting pairs",
             fmt::format("{} (of these unwelded: {})", c.intersecting_pairs, c.unwelded_pairs));
  lines.line("intersecting faces", c.intersecting_faces);
}

void append_extent(LineSink& lines, const Characteristics& c) {
  if (c.bounding_box.isEmpty()) {
    lines.line("bounding box", "undefined (no face)");
  } else {
    lines.line("bounding box min", point_text(c.bounding_box.min()));
    lines.line("bounding box max", point_text(c.bounding_box.max()));
  }
  lines.line("area", c.area);
  if (c.volume.value) {
    lines.line("volume", *c.volume.value);
  } else {
    lines.line("volume", undefined(c.volume.reason));
  }
  lines.line("genus", genus_text(c));
}

}  // namespace meshalyzer
