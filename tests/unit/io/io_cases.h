#pragma once

#include "meshalyzer/base/error.h"
#include "meshalyzer/mesh/soup.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace meshalyzer {

/// A text that a parser must refuse, and how its message must begin.
struct RefusedText {
  std::string text;
  std::string message_begin;
};

/// The message of the IoError that the call throws, or "accepted".
template <typename Call>
std::string error_of(Call&& call) {
  try {
    static_cast<void>(call());
  } catch (const IoError& error) {
    return error.what();
  }
  return "accepted";
}

/// The first bytes of `text`, as many as `other` has.
inline std::string begin_like(const std::string& text, const std::string& other) {
  return text.substr(0, other.size());
}

/// A random finite double: any bits, so that denormal, tiny and huge ones come as often as others.
inline double any_finite(std::mt19937_64& random) {
  for (;;) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) {
      return value;
    }
  }
}

/// A strip of triangles over points whose coordinates are hard to print: random bits and the ends
/// of the range.
inline Soup strip_of_hard_numbers(std::size_t n_vertices) {
  std::mt19937_64 random(20261121);
  Soup soup;
  soup.positions = {
      {-0.0, 0.0, std::numeric_limits<double>::denorm_min()},
      {1e308, -std::numeric_limits<double>::max(), std::numeric_limits<double>::min()},
      {0.1, 9007199254740993.0, 1e22}};
  while (soup.n_vertices() < n_vertices) {
    const double x = any_finite(random);
    const double y = any_finite(random);
    soup.positions.emplace_back(x, y, any_finite(random));
  }
  for (Index v = 0; v + 2 < n_vertices; ++v) {
    soup.triangles.push_back({v, v + 1, v + 2});
  }
  return soup;
}

}  // namespace meshalyzer
