#pragma once

#include "meshalyzer/repair/edits/internal/face_models.h"

#include <span>

namespace meshalyzer {

/// Gives the vertices of an edited soup their normals, where each has one. A new vertex on faces
/// that are parts of old ones has their normal there; one of a hole patch, or on its rim, the mean
/// of the normals of its faces, weighted by the angle there.
///
/// @param vertices  By new vertex: the old vertex that it is, or #old vertices + the number of the
///                  added one.
/// @param result    A soup with its positions and triangles; receives normals.
/// @complexity      O(#F).
void set_vertex_normals(const FaceModels& models, std::span<const Index> vertices, Soup& result);

}  // namespace meshalyzer
