#include "meshalyzer/report/text/summary_table.h"

#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/report/text/table.h"
#include "meshalyzer/report/utf8.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::size_t kMinWidth = 8;
constexpr std::size_t kMaxWidth = 40;
constexpr std::string_view kNone = "-";

/// Returns the characters of a text.
std::vector<std::string> characters_of(std::string_view name) {
  std::vector<std::string> characters;
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t length = std::max<std::size_t>(1, utf8_sequence_length(name, i));
    characters.emplace_back(name.substr(i, length));
    i += length;
  }
  return characters;
}

/// Shortens a name to a width. It keeps more of the end, since that is where names in one folder
/// mostly differ.
std::string fitted_name(std::string_view name, std::size_t width) {
  std::vector<std::string> characters = characters_of(without_controls(name));
  if (characters.size() > width) {
    constexpr std::string_view kEllipsis = "...";
    const std::size_t kept = width - kEllipsis.size();
    const auto front = static_cast<std::ptrdiff_t>(kept / 2);
    const auto back = static_cast<std::ptrdiff_t>(kept - kept / 2);
    characters.erase(characters.begin() + front, characters.end() - back);
    characters.emplace(characters.begin() + front, kEllipsis);
  }
  std::string text;
  for (const std::string& character : characters) {
    text += character;
  }
  return text + std::string(width - std::min(width, n_characters(text)), ' ');
}

/// Returns the text of a number; one that is too long for its column has fewer digits.
std::string fitted(std::size_t count, std::size_t width) {
  std::string text = std::to_string(count);
  for (int digits = 2; text.size() > width && digits >= 0; --digits) {
    text = fmt::format("{:.{}e}", static_cast<double>(count), digits);
  }
  return text;
}

std::string fitted(double value, std::size_t width) {
  std::string text;
  for (int digits = 5; (text.empty() || text.size() > width) && digits > 0; --digits) {
    text = fmt::format("{:.{}g}", value + 0.0, digits);
  }
  return text;
}

/// Returns the text of a number that only whole analyses have.
template <typename T>
std::string measured(const Analysis& analysis, T value, std::size_t width) {
  return analysis.has_characteristics ? fitted(value, width) : std::string(kNone);
}

/// Returns a number with no digit but its first.
std::size_t rounded_down(std::size_t number) {
  std::size_t unit = 1;
  while (number / unit >= 10) unit *= 10;
  return number / unit * unit;
}

/// Returns the number of intersecting pairs, as ">=85" where the search was stopped: then it is not
/// rounded up.
std::string pairs_cell(const Analysis& analysis, std::size_t width) {
  const Characteristics& c = analysis.characteristics;
  if (!c.is_search_stopped) return measured(analysis, c.intersecting_pairs, width);
  constexpr std::string_view kAtLeast = ">=";
  const std::string all = std::to_string(c.intersecting_pairs);
  const std::size_t left = width - kAtLeast.size();
  return std::string(kAtLeast) +
         (all.size() <= left ? all : fitted(rounded_down(c.intersecting_pairs), left));
}

/// A column of the table: its title and its entry for a mesh.
struct SummaryColumn {
  std::string_view title;
  std::size_t width = 0;
  std::string (*cell)(const Analysis& analysis, std::size_t width) = nullptr;
};

/// Returns the column of an attribute.
template <auto Member>
constexpr SummaryColumn attribute(std::string_view title) {
  return {title, title.size(), [](const Analysis& analysis, std::size_t /*width*/) {
            return truth_cell((analysis.attributes.*Member).value);
          }};
}

constexpr std::array kSummaryColumns{
    SummaryColumn{"faces", 8,
                  [](const Analysis& analysis, std::size_t width) {
                    return fitted(analysis.characteristics.faces, width);
                  }},
    attribute<&Attributes::closed>("closed"),
    attribute<&Attributes::manifold>("manifold"),
    attribute<&Attributes::outward>("outward"),
    SummaryColumn{"comps", 5,
                  [](const Analysis& analysis, std::size_t width) {
                    return fitted(analysis.characteristics.components, width);
                  }},
    SummaryColumn{"genus", 5,
                  [](const Analysis& analysis, std::size_t /*width*/) {
                    const auto& genus = analysis.characteristics.genus.value;
                    return genus ? std::to_string(*genus) : std::string(kNone);
                  }},
    SummaryColumn{"selfint", 7, pairs_cell},
    SummaryColumn{"area", 9,
                  [](const Analysis& analysis, std::size_t width) {
                    return measured(analysis, analysis.characteristics.area, width);
                  }},
    SummaryColumn{"volume", 10,
                  [](const Analysis& analysis, std::size_t width) {
                    const auto& volume = analysis.characteristics.volume.value;
                    return volume ? fitted(*volume, width) : std::string(kNone);
                  }},
    SummaryColumn{"good", 4,
                  [](const Analysis& analysis, std::size_t /*width*/) {
                    const std::optional<Goodness>& verdict = verdict_of(analysis);
                    return truth_cell(verdict ? std::optional(verdict->good) : std::nullopt);
                  }},
};

/// @param cell  Returns the entry of a column.
template <typename CellOf>
std::string line_of(std::string name, CellOf cell) {
  for (const SummaryColumn& column : kSummaryColumns) {
    name += fmt::format(" {:>{}}", cell(column), column.width);
  }
  return name;
}

}  // namespace

std::size_t summary_width(std::span<const std::string> names, NameLength length) {
  std::size_t width = kMinWidth;
  for (const std::string& name : names) {
    width = std::max(width, n_characters(name));
  }
  return length == NameLength::Whole ? width : std::min(width, kMaxWidth);
}

std::string summary_header(std::size_t width) {
  return line_of(fitted_name("mesh", width),
                 [](const SummaryColumn& column) { return column.title; }) +
         "  reason\n";
}

std::string summary_line(std::string_view name, const Analysis& analysis, std::size_t width) {
  const std::optional<Goodness>& verdict = verdict_of(analysis);
  const bool has_reason = verdict && !verdict->reasons.empty();
  const auto cell = [&](const SummaryColumn& column) {
    return column.cell(analysis, column.width);
  };
  return line_of(fitted_name(name, width), cell) +
         (has_reason ? "  " + verdict->reasons.front() : "") + '\n';
}

std::string summary_of_unreadable(std::string_view name, std::string_view why, std::size_t width) {
  const auto cell = [](const SummaryColumn& column) {
    return &column == &kSummaryColumns.back() ? "no" : kNone;
  };
  return line_of(fitted_name(name, width), cell) + "  cannot be read: " + std::string(why) + '\n';
}

}  // namespace meshalyzer
