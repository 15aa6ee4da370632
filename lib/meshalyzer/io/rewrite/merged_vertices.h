#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"

#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A vertex of the source that was dropped although faces at it stay, as where two borders are
/// welded: these name another vertex now, which has attributes of its own.
struct MergedVertex {
  /// The record of the vertex that was dropped.
  Index gone;
  /// The vertex of the edited mesh in its place.
  Index now;
  /// The record that gives this vertex its attributes.
  Index kept;
};

/// What became of the vertices of the source that were dropped.
struct VertexMerges {
  /// Those that were merged into others with which they had no face in common, ascending. Where an
  /// edge was collapsed to one of its ends, nothing is in the place of the other.
  std::vector<MergedVertex> merged;
  /// The new number of each vertex record, by which lines and other records name it: that of the
  /// vertex in its place if it was merged or collapsed, and kNoIndex if it was dropped.
  std::vector<Index> names;
};

/// Finds the vertices in the place of dropped ones.
///
/// @param numbers  The result of new_vertices().
/// @complexity O(#V + #F) time and space.
[[nodiscard]] VertexMerges find_vertex_merges(const EditedMesh& mesh,
                                              const std::vector<Index>& numbers);

/// Tells whether vertices that one record names are the same vertex now.
/// @param names  The vertex records that it names.
[[nodiscard]] bool are_joined(std::vector<Index> names, const std::vector<Index>& numbers);

/// Tells whether numbers are lost where others stand in their place: there are any, and the others
/// have not the same values.
[[nodiscard]] bool are_lost_in(std::span<const std::string_view> gone,
                               std::span<const std::string_view> kept);

}  // namespace meshalyzer
