#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/text/lines.h"

#include <array>
#include <string>
#include <string_view>

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

/// The edges of the bins with as few digits, from four, as keep neighbours apart.
[[nodiscard]] std::array<std::string, Histogram::kBins + 1> edge_texts(const Histogram& histogram);

/// Appends the figures of a quantity, one a line, and its histogram as rows of two bins.
///
/// A histogram needs two different values; its bins are printed with as few digits as tell them
/// apart.
void append_statistics(TextLines& lines, const QuantityName& quantity,
                       const Statistics& statistics);

/// Calls `tell(QuantityName, Statistics)` for each of what is measured of faces, edges and
/// vertices.
/// @tparam Measures  Characteristics of a mesh, or SetStatistics.
template <typename Measures, typename Tell>
void for_each_measure(const Measures& measures, Tell tell) {
  using Total = QuantityName::Total;
  tell(QuantityName{"vertex valence", "no face"}, measures.vertex_valence);
  tell(QuantityName{"face area", "no face", Total::Show}, measures.face_area);
  tell(QuantityName{"aspect ratio", "no face with an area"}, measures.aspect_ratio);
  tell(QuantityName{"edge length", "no edge", Total::Show}, measures.edge_length);
  tell(QuantityName{"edge angle", "no edge between two consistently oriented faces with an area"},
       measures.edge_angle);
}

/// Appends the statistics of all of them.
template <typename Measures>
void append_measures(TextLines& lines, const Measures& measures) {
  for_each_measure(measures, [&](const QuantityName& quantity, const Statistics& statistics) {
    append_statistics(lines, quantity, statistics);
  });
}

}  // namespace meshalyzer
