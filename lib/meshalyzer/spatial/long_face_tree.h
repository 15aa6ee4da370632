#pragma once

#include "meshalyzer/spatial/face_tree.h"

#include <optional>

namespace meshalyzer {

/// Makes a tree again with boxes along the axes that most of its faces run along, if most are long
/// and thin, as where the walls of a turned box were cut: boxes along other axes are as wide there
/// as the faces are long, and tell hardly any apart.
///
/// A sample of the faces is looked at, so such axes may be missed, or others be taken than the
/// best.
///
/// @return  Nothing where faces are few, or not long, or run along the axes of the file or along
///          no three that are perpendicular, and where some are far (see FaceTree).
/// @complexity O(1); that of the tree if one is made.
[[nodiscard]] std::optional<FaceTree> turned_for_long_faces(const FaceTree& tree);

}  // namespace meshalyzer
