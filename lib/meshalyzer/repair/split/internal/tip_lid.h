#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/mesh/soup.h"

#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Closes a surface from which the tip round a vertex was cut off.
///
/// Each triangle of the lid is seen from the apex in the same sense, and beside all others; so the
/// lid lies on that side of the tip where nothing else touches the apex. It is made by cutting off
/// ears (Meisters 1975, "Polygons have ears") as the apex sees them: decided exactly, ears with
/// short diagonals first.
///
/// @param apex    Where the tip was.
/// @param ring    At least three points, one on each edge at the apex, in the order of the faces
///                (apex, ring[i], ring[i + 1]) of the tip.
/// @param others  The other ends of the edges of other surfaces that touch the apex.
/// @return  Triangles by number in the ring, in the direction of the faces; nothing if there is no
///          such lid.
/// @complexity O(#ring^2 (#ring + #others)).
[[nodiscard]] std::optional<std::vector<Triangle>> close_tip(const Vec3& apex,
                                                             std::span<const Vec3> ring,
                                                             std::span<const Vec3> others);

}  // namespace meshalyzer
