#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/text_lines.h"

namespace meshalyzer {

/// What a quantity is called in a report, and what there is to say of it.
struct QuantityName {
  std::string_view name;
  /// Why there may be no value of it, in words that follow "undefined: ".
  std::string_view if_none;
  enum class Total { Omit, Show };
  /// Whether the sum of all values means something.
  Total total = Total::Omit;
};

/// Appends the figures of a quantity, one a line, and its histogram as rows of two bins.
///
/// A histogram needs two different values; its bins are printed with as few digits as tell them
/// apart.
void append_statistics(TextLines& lines, const QuantityName& quantity,
                       const Statistics& statistics);

/// Appends the statistics of what is measured of faces, edges and vertices.
/// @tparam Measures  Characteristics of a mesh, or SetStatistics.
template <typename Measures>
void append_measures(TextLines& lines, const Measures& measures) {
  using Total = QuantityName::Total;
  append_statistics(lines, {"vertex valence", "no face"}, measures.vertex_valence);
  append_statistics(lines, {"face area", "no face", Total::Show}, measures.face_area);
  append_statistics(lines, {"aspect ratio", "no face with an area"}, measures.aspect_ratio);
  append_statistics(lines, {"edge length", "no edge", Total::Show}, measures.edge_length);
  append_statistics(lines,
                    {"edge angle", "no edge between two consistently oriented faces with an area"},
                    measures.edge_angle);
}

}  // namespace meshalyzer
