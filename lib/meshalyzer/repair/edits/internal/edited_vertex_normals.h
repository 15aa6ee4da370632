#pragma once

#include "meshalyzer/repair/edits/internal/face_models.h"

#include <span>

namespace meshalyzer {

/// Gives the vertices of an edited soup their normals, where each has one. A new vertex has the
/// mean of the normals there of the faces of which its faces are parts, and of those of hole
/// patches, weighted by the angles at the vertex.
///
/// @param vertices  By new vertex: the old vertex that it is, or #old vertices + the number of the
///                  added one.
/// @param result    A soup with its positions and triangles; receives normals.
/// @complexity      O(#F).
void set_vertex_normals(const FaceModels& models, std::span<const Index> vertices, Soup& result);

}  // namespace meshalyzer
