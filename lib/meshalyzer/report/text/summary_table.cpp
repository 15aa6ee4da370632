#include "meshalyzer/report/text/summary_table.h"

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

struct Column {
  std::string_view title;
  std::size_t width = 0;
};

constexpr std::array<Column, 10> kColumns{{{"faces", 8},
                                           {"closed", 6},
                                           {"manifold", 8},
                                           {"outward", 7},
                                           {"comps", 5},
                                           {"genus", 5},
                                           {"selfint", 7},
                                           {"area", 9},
                                           {"volume", 10},
                                           {"good", 4}}};
using Cells = std::array<std::string, kColumns.size()>;

/// The characters of a name, control characters replaced: these would break the line.
std::vector<std::string> characters_of(std::string_view name) {
  std::vector<std::string> characters;
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t length = std::max<std::size_t>(1, utf8_sequence_length(name, i));
    const auto code = static_cast<unsigned char>(name[i]);
    characters.emplace_back(code < 0x20U || code == 0x7FU ? "?" : name.substr(i, length));
    i += length;
  }
  return characters;
}

/// Shortens a name to a width. It keeps more of the end, since that is where names in one folder
/// mostly differ.
std::string fitted_name(std::string_view name, std::size_t width) {
  std::vector<std::string> characters = characters_of(name);
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

/// A number that is too long for its column is shown with fewer digits.
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

std::string line_of(std::string name, const Cells& cells) {
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    name += fmt::format(" {:>{}}", cells[i], kColumns[i].width);
  }
  return name;
}

const std::optional<Goodness>& goodness_of(const Analysis& analysis) {
  return analysis.goodness ? analysis.goodness : analysis.fitness;
}

Cells cells_of(const Analysis& analysis) {
  const Characteristics& c = analysis.characteristics;
  const Attributes& attributes = analysis.attributes;
  const std::optional<Goodness>& verdict = goodness_of(analysis);
  const auto measured = [&](auto value, std::size_t column) {
    return analysis.has_characteristics ? fitted(value, kColumns[column].width)
                                        : std::string(kNone);
  };
  return {fitted(c.faces, kColumns[0].width),
          truth_cell(attributes.closed.value),
          truth_cell(attributes.manifold.value),
          truth_cell(attributes.outward.value),
          fitted(c.components, kColumns[4].width),
          c.genus.value ? std::to_string(*c.genus.value) : std::string(kNone),
          measured(c.intersecting_pairs, 6),
          measured(c.area, 7),
          c.volume.value ? fitted(*c.volume.value, kColumns[8].width) : std::string(kNone),
          truth_cell(verdict ? std::optional(verdict->good) : std::nullopt)};
}

}  // namespace

std::size_t summary_width(std::span<const std::string> names) {
  std::size_t width = kMinWidth;
  for (const std::string& name : names) {
    width = std::max(width, n_characters(name));
  }
  return std::min(width, kMaxWidth);
}

std::string summary_header(std::size_t width) {
  Cells titles;
  std::transform(kColumns.begin(), kColumns.end(), titles.begin(),
                 [](const Column& column) { return std::string(column.title); });
  return line_of(fitted_name("mesh", width), titles) + "  reason\n";
}

std::string summary_line(std::string_view name, const Analysis& analysis, std::size_t width) {
  const std::optional<Goodness>& verdict = goodness_of(analysis);
  const bool has_reason = verdict && !verdict->reasons.empty();
  return line_of(fitted_name(name, width), cells_of(analysis)) +
         (has_reason ? "  " + verdict->reasons.front() : "") + '\n';
}

std::string summary_of_unreadable(std::string_view name, std::string_view why, std::size_t width) {
  Cells cells;
  cells.fill(std::string(kNone));
  cells.back() = "no";
  return line_of(fitted_name(name, width), cells) + "  cannot be read: " + std::string(why) + '\n';
}

}  // namespace meshalyzer
