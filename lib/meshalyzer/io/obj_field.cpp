#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/field_formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// Returns the intensities 0 ... 1 of the 256 steps of a channel, in four digits.
///
/// They are rounded up, so that multiplying by 255 gives the same step whether a reader rounds or
/// truncates.
std::array<std::string, 256> make_intensities() {
  constexpr unsigned kSteps = 10'000;
  std::array<std::string, 256> texts;
  for (unsigned step = 0; step < texts.size(); ++step) {
    append_shortest(texts[step], (step * kSteps + 254) / 255 / double{kSteps});
  }
  return texts;
}

void print_vertices(std::string& text, const MeshField& field) {
  const std::array<std::string, 256> intensities = make_intensities();
  for (std::size_t v = 0; v < field.positions.size(); ++v) {
    text += 'v';
    for (const double coordinate : field.positions[v]) {
      text += ' ';
      append_shortest(text, coordinate);
    }
    const Colour& colour = field.vertices.colours[v];
    for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
      text.append(1, ' ').append(intensities[channel]);
    }
    text += '\n';
  }
}

void print_values(std::string& text, std::span<const double> values) {
  for (const double value : values) {
    text += "vt ";
    append_shortest(text, std::isfinite(value) ? value : 0.0);
    text += " 0\n";
  }
}

void print_faces(std::string& text, const MeshField& field) {
  const auto has_value = [&](Index v) { return std::isfinite(field.vertices.values[v]); };
  for (const Triangle& t : field.triangles) {
    const bool has_values = std::all_of(t.begin(), t.end(), has_value);
    text += 'f';
    for (const Index corner : t) {
      const std::string number = std::to_string(std::uint64_t{corner} + 1);
      text.append(1, ' ').append(number);
      if (has_values) {
        text.append(1, '/').append(number);
      }
    }
    text += '\n';
  }
}

}  // namespace

std::string print_obj_field(const MeshField& field) {
  std::string text;
  for (const std::string& comment : field.comments) {
    text.append("# ").append(comment) += '\n';
  }
  text +=
      "# v: x y z red green blue; vt: the value; where it is not finite 0, which no face names\n";
  print_vertices(text, field);
  print_values(text, field.vertices.values);
  print_faces(text, field);
  return text;
}

}  // namespace meshalyzer
