#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Returns the ids of records in file order, without a list where they are first, first + 1, first
/// + 2, ...
[[nodiscard]] Ids compact_ids(std::vector<std::int32_t> ids);

/// Turns the vertex ids that soup.triangles hold into record indices, the first record of an id
/// counting, and fills soup.missing. Needs soup.positions and soup.vertex_ids.
///
/// @complexity O(V log V + F log V) time and O(V) memory, whatever the ids.
void resolve_ids(Soup& soup);

/// Turns those indices in soup.triangles that lie beyond the last vertex into missing references.
///
/// For formats whose indices count from soup.vertex_ids.first; in soup.triangles they count from 0.
void resolve_indices(Soup& soup);

/// Appends the triangles that a polygon is kept as, fanned from its first corner: see
/// Soup::triangles.
/// @param corners  What stands at the corners; not empty.
void append_fan(std::vector<Triangle>& triangles, const std::vector<Index>& corners);

/// Appends a face record to the soup: triangles and, where `line` is not 0, their lines.
void append_polygon(Soup& soup, const std::vector<Index>& corners, std::size_t line);

/// Tells whether the soup has one normal a vertex, used by every corner at it.
[[nodiscard]] bool has_vertex_normals(const Soup& soup);

/// Makes the normals, one a vertex, those of the corners. Call after the indices are resolved.
void use_vertex_normals(Soup& soup);

/// @throws InvalidArgument if a face has a corner without a vertex: no format could say so.
void require_all_vertices(const Soup& soup);

}  // namespace meshalyzer
