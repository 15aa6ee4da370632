#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <optional>

namespace meshalyzer {

/// What two faces have in common by id.
enum class Common : std::uint8_t { Nothing, Vertex, Edge, All };

/// Tells whether two closed triangles share a point that is not on what they have in common, and
/// how.
///
/// The answer is exact: it agrees with the evaluation over the reals for all finite doubles. A
/// triangle of zero area counts as the segment or point that it is.
///
/// @param p, q    The triangles. Common corners come first, in the same order in both.
/// @param common  What they have in common.
/// @return        Nothing if there is no such point, else the kind. It is never Unwelded, which two
///                calls decide.
[[nodiscard]] std::optional<ContactKind> find_contact(const Corners& p, const Corners& q,
                                                      Common common);

/// Tells whether a quick test proves that find_contact() finds nothing. False means that nothing is
/// proven.
///
/// It decides most neighbours of a mesh with two signs and no exact arithmetic: triangles that lie
/// on one side of each other's plane, or whose projections along an axis meet only in the common
/// part.
[[nodiscard]] bool are_clearly_apart(const Corners& p, const Corners& q, Common common);

}  // namespace meshalyzer
