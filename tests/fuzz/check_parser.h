#pragma once

#include "meshalyzer/base/error.h"
#include "meshalyzer/mesh/soup.h"
#include "support/same_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace meshalyzer {

/// What a parser promises of any soup: each index names a record or is kNoIndex, each list is as
/// long as it says.
inline bool is_well_formed(const Soup& soup) {
  std::size_t n_missing = 0;
  for (const Triangle& triangle : soup.triangles) {
    for (const Index corner : triangle) {
      if (corner != kNoIndex && corner >= soup.n_vertices()) {
        return false;
      }
      n_missing += corner == kNoIndex ? 1 : 0;
    }
  }
  const auto is_finite = [](const Vec3& v) { return v.allFinite(); };
  return n_missing == soup.missing.size() &&
         (soup.vertex_lines.empty() || soup.vertex_lines.size() == soup.n_vertices()) &&
         (soup.face_lines.empty() || soup.face_lines.size() == soup.n_faces()) &&
         (soup.corner_normals.empty() || soup.corner_normals.size() == soup.n_faces()) &&
         std::all_of(soup.positions.begin(), soup.positions.end(), is_finite);
}

/// Any bytes are either refused by an IoError or make a well-formed soup, which printing and
/// parsing again gives back.
template <typename Parse, typename Print>
void check_parser(std::string_view content, Parse parse, Print print) {
  Soup soup;
  try {
    soup = parse(content, "fuzz");
  } catch (const IoError&) {
    return;
  }
  if (!is_well_formed(soup)) {
    std::abort();
  }
  if (soup.missing.empty() && soup.n_vertices() + soup.n_faces() > 0) {
    const std::string printed = print(soup);
    if (!same_soup(parse(printed, "printed"), soup)) {
      std::abort();
    }
  }
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace meshalyzer
