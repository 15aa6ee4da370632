#include "meshalyzer/report/text/components.h"

#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

std::string cell_of(double value) {
  return readable(value);
}

template <std::integral Integer>
std::string cell_of(Integer value) {
  if constexpr (std::same_as<Integer, bool>) {
    return truth_cell(value);
  } else {
    return std::to_string(value);
  }
}

template <typename T>
std::string cell_of(const std::optional<T>& value) {
  return value ? cell_of(*value) : "-";
}

/// A column of the table: its title and its entry for each component.
struct ComponentColumn {
  std::string_view title;
  std::string (*cell)(const Analysis& analysis, std::size_t number);
  /// Tells whether the entries are only lower bounds if the search for intersecting pairs was
  /// stopped.
  bool counts_pairs = false;
};

/// Returns the column of a member of a component.
template <auto Member>
constexpr ComponentColumn column(std::string_view title, bool counts_pairs = false) {
  return {title,
          [](const Analysis& analysis, std::size_t number) {
            return cell_of(analysis.components[number].*Member);
          },
          counts_pairs};
}

constexpr std::array kComponentColumns{
    ComponentColumn{"component",
                    [](const Analysis&, std::size_t number) { return cell_of(number); }},
    ComponentColumn{"first face",
                    [](const Analysis& analysis, std::size_t number) {
                      return cell_of(analysis.face_ids.of(analysis.components[number].first_face));
                    }},
    column<&ComponentAnalysis::faces>("faces"),
    column<&ComponentAnalysis::vertices>("vertices"),
    column<&ComponentAnalysis::edges>("edges"),
    column<&ComponentAnalysis::boundaries>("boundaries"),
    column<&ComponentAnalysis::closed>("closed"),
    column<&ComponentAnalysis::manifold>("manifold"),
    column<&ComponentAnalysis::consistent>("consistent"),
    column<&ComponentAnalysis::outward>("outward"),
    column<&ComponentAnalysis::inside>("inside"),
    column<&ComponentAnalysis::genus>("genus"),
    column<&ComponentAnalysis::area>("area"),
    column<&ComponentAnalysis::volume>("volume"),
    column<&ComponentAnalysis::intersecting_pairs>("intersecting pairs", true),
};

}  // namespace

TextTable components_table(const Analysis& analysis, std::size_t n) {
  TextTable table;
  std::vector<std::string>& titles = table.rows.emplace_back();
  for (const ComponentColumn& column : kComponentColumns) {
    const bool is_at_least = column.counts_pairs && analysis.characteristics.is_search_stopped;
    titles.emplace_back(column.title).append(is_at_least ? kAtLeastTitle : "");
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    for (const ComponentColumn& column : kComponentColumns) {
      cells.push_back(column.cell(analysis, i));
    }
  }
  return table;
}

void append_components(TextLines& lines, const Analysis& analysis) {
  const std::size_t n = analysis.components.size();
  if (n < 2) {
    return;
  }
  const std::size_t n_shown = std::min(n, kMaxComponentRows);
  lines.line("components, one a row",
             n_shown == n ? "all" : fmt::format("the first {} of {}", n_shown, n));
  append_table(lines.text(), components_table(analysis, n_shown));
  if (n_shown < n) {
    lines.line("components not shown",
               fmt::format("{} (the JSON report has them all)", n - n_shown));
  }
}

}  // namespace meshalyzer
