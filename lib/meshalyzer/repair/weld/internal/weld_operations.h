#pragma once

#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/weld/internal/weld_classes.h"
#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): conversion of joins to edits.

/// The data that the stages of a weld share.
struct WeldState {
  const WeldRules& rules;
  std::span<const WeldEdge> edges;
  /// #V: non-zero for vertices of faces that an operation affects already; their edges wait for the
  /// next run.
  std::vector<std::uint8_t> is_busy;
  PassResult result;
};

/// Records that a pair of edges is left as it is.
void refuse(WeldState& state, const WeldJoin& join, std::string_view reason);

/// Makes operations of the joins that check_merges() accepts; the others are refused. Joins that
/// are connected, or affect the same face, are one operation.
///
/// @param joins  The joins, with each edge once at most and no busy vertex.
void add_weld_operations(WeldState& state, std::vector<WeldJoin> joins);

}  // namespace meshalyzer
