#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <optional>

namespace meshalyzer {

/// Tells how much two faces have in common by id.
enum class Common : std::uint8_t { Nothing, Vertex, Edge, All };

/// Tells whether two closed triangles share a point that is not on what they have in common, and
/// how.
///
/// Exact: it agrees with the evaluation over the reals for all finite doubles. A triangle of zero
/// area counts as the segment or point that it is.
///
/// @param p, q    The corners that they have in common come first, in the same order in both.
/// @param common  How many those are.
/// @return        Nothing when there is no such point; else the kind, never Unwelded (that takes
/// two questions).
[[nodiscard]] std::optional<ContactKind> find_contact(const Corners& p, const Corners& q,
                                                      Common common);

/// Tells whether a quick test proves that find_contact() has nothing to find. False says nothing.
///
/// Decides most neighbours of a mesh with two signs, without ever going exact: triangles that lie
/// on one side of each other's plane, or whose projections along an axis meet in nothing but the
/// common part.
[[nodiscard]] bool are_clearly_apart(const Corners& p, const Corners& q, Common common);

}  // namespace meshalyzer
