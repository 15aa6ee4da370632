#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace meshalyzer {

/// The ways to fill a hole.
enum class FillShape : std::uint8_t {
  /// The patch is Smooth if the hole has more than a few edges and the surface round it bends
  /// towards it; it is Linear if the surface is flat or ends at a crease.
  Auto,
  /// The patch is the triangulation of its border that bends least, and of those the one of least
  /// area. It has no new vertices unless only they make a patch without contacts.
  Linear,
  /// The patch is refined to the density of its surroundings, and faired.
  Smooth,
};

/// The open parts whose holes are filled.
enum class FillSheets : std::uint8_t {
  /// Only the holes of parts that bound a solid are filled: at least half of their surface
  /// separates inside from outside.
  No,
  Yes,
};

struct FillOptions {
  /// Loops with more edges are left open.
  std::size_t max_edges = std::numeric_limits<std::size_t>::max();
  /// If a point is given, only the loop nearest to it is filled. It is finite.
  std::optional<Vec3> at = {};
  FillShape shape = FillShape::Auto;
  FillSheets sheets = FillSheets::No;
};

}  // namespace meshalyzer
