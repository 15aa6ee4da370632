#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Returns the ids of records in file order, without a list if they are first, first + 1, first +
/// 2, ...
[[nodiscard]] Ids compact_ids(std::vector<std::int32_t> ids);

/// Converts the vertex ids in soup.triangles to record indices, those of the first record of an id,
/// and fills soup.missing. soup.positions and soup.vertex_ids must be set.
///
/// @complexity O(V log V + F log V) time and O(V) memory for any ids.
void resolve_ids(Soup& soup);

/// Converts indices in soup.triangles beyond the last vertex to missing references.
///
/// It serves formats whose indices count from soup.vertex_ids.first; in soup.triangles they count
/// from 0.
void resolve_indices(Soup& soup);

/// Appends the triangles of a polygon, fanned from its first corner: see Soup::triangles.
/// @param corners  The indices at the corners; not empty.
void append_fan(std::vector<Triangle>& triangles, const std::vector<Index>& corners);

/// Appends a face record to the soup: triangles and, if `line` is not 0, their lines.
void append_polygon(Soup& soup, const std::vector<Index>& corners, std::size_t line);

/// Tells whether the soup has one normal for each vertex, used by every corner at it.
[[nodiscard]] bool has_vertex_normals(const Soup& soup);

/// Assigns the normals, one for each vertex, to the corners. The indices must have been resolved.
void use_vertex_normals(Soup& soup);

/// Checks that all corners have vertices.
/// @throws InvalidArgument if a face has a corner without a vertex, which no format can hold.
void require_all_vertices(const Soup& soup);

/// Checks that no face has a vertex whose id belongs to an earlier vertex.
/// @throws InvalidArgument if one has: by this id the face would get the earlier vertex.
/// @complexity O(V) if ids ascend, else O((V + F) log V).
void require_unambiguous_ids(const Soup& soup);

}  // namespace meshalyzer
