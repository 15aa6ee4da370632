#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The numbers of records of each kind before a statement.
struct ObjCounts {
  std::size_t vertices = 0;
  std::size_t texture_points = 0;
  std::size_t normals = 0;
};

/// The records that a corner of a face names, by index from 0.
struct ObjCorner {
  Index vertex = kNoIndex;
  /// The texture point; kNoIndex if none is named.
  Index texture_point = kNoIndex;
  Index normal = kNoIndex;
};

/// Reads one number of a corner.
[[nodiscard]] inline Index parse_obj_reference(std::string_view field, std::size_t n_so_far,
                                               std::string_view token, const TextScanner& in) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (field.empty() || error == std::errc::invalid_argument || end != field.data() + field.size()) {
    in.fault(in_quotes(token) + " is no corner of a face");
  }
  if (error != std::errc{} || value > kLargestIndex) {
    in.fault("index " + std::string(field) + " is beyond " + std::to_string(kLargestIndex));
  }
  if (value == 0) {
    in.fault("index 0: indices count from 1");
  }
  if (value > 0) {
    return static_cast<Index>(value - 1);
  }
  if (value < -static_cast<std::int64_t>(n_so_far)) {
    in.fault("index " + std::string(field) + " reaches back beyond the first of " +
             std::to_string(n_so_far));
  }
  return static_cast<Index>(static_cast<std::int64_t>(n_so_far) + value);
}

/// Reads v, v/, v/t, v/t/, v/t/n, v//, v//n. A positive number counts from the first record of the
/// file, a negative one backwards from the last record so far.
///
/// @param in  The scanner, which throws if the token is no corner.
[[nodiscard]] inline ObjCorner parse_obj_corner(std::string_view token, const ObjCounts& n_so_far,
                                                const TextScanner& in) {
  std::array<std::string_view, 3> fields;
  std::size_t begin = 0;
  for (std::size_t n = 0; begin <= token.size(); ++n) {
    if (n == fields.size()) {
      in.fault(in_quotes(token) + " is no corner of a face");
    }
    const std::size_t end = std::min(token.find('/', begin), token.size());
    fields[n] = token.substr(begin, end - begin);
    begin = end + 1;
  }
  ObjCorner corner;
  if (!fields[1].empty()) {
    corner.texture_point = parse_obj_reference(fields[1], n_so_far.texture_points, token, in);
  }
  corner.vertex = parse_obj_reference(fields[0], n_so_far.vertices, token, in);
  if (!fields[2].empty()) {
    corner.normal = parse_obj_reference(fields[2], n_so_far.normals, token, in);
  }
  return corner;
}

}  // namespace meshalyzer
