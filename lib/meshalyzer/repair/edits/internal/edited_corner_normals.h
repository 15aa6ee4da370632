#pragma once

#include "meshalyzer/repair/edits/internal/face_models.h"

namespace meshalyzer {

/// Gives the faces of an edited soup the normals of their corners, where each corner refers to one
/// of a list. Parts of a face have those of the face there; hole patches have none.
///
/// @param result  A soup with its positions and triangles; receives normals.
/// @complexity    O(#F).
void set_corner_normals(const FaceModels& models, Soup& result);

}  // namespace meshalyzer
