#pragma once

#include "meshalyzer/base/corners.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module: triangulations of a nearly flat closed outline of a few vertices in
// space. Everything is seen along the normal of the outline, the vector area that it encloses.

/// Returns the middle of the positions that see all of an outline, at the mean height of its
/// vertices: with a vertex there, no face of the fan to the outline is turned over.
///
/// @param outline  Counter-clockwise.
/// @return         Nothing if there is no such position, or hardly any room for it.
/// @complexity     O(n^2).
[[nodiscard]] std::optional<Vec3> middle_of_kernel(std::span<const Vec3> outline);

/// Tells whether two vertices of the outline, by number, may get an edge.
using MayJoin = std::function<bool(Index, Index)>;

/// Triangulates an outline by cutting off ears (Meisters 1975, "Polygons have ears"), of the
/// possible ones the best shaped first. The turns of corners are decided exactly.
///
/// @param outline  Counter-clockwise.
/// @return         Triangles by number in the outline, n - 2 of them; nothing if no ear is left,
/// because the outline crosses itself, or because an edge is not permitted.
/// @complexity     O(n^3).
[[nodiscard]] std::vector<Triangle> cut_ears(std::span<const Vec3> outline,
                                             const MayJoin& may_join);

/// Returns the shortest altitude of a triangle over its longest edge, 0 ... sqrt(3) / 2.
[[nodiscard]] double shape_quality(const Corners& t);

}  // namespace meshalyzer
