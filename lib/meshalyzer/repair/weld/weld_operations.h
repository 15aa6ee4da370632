#pragma once

#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/weld/weld_classes.h"
#include "meshalyzer/repair/weld/weld_edges.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): from joins to edits.

/// What the stages of a weld have in common.
struct WeldStage {
  const WeldRules& rules;
  std::span<const WeldEdge> edges;
  /// #V: vertices of faces that an operation touches already; their edges wait for the next time.
  std::vector<std::uint8_t> is_busy;
  PassResult result;
};

/// Notes that a pair of edges is left as it is.
void refuse(WeldStage& stage, const WeldJoin& join, std::string_view reason);

/// Makes operations of joins, but for those that would do harm (see find_weld_harms()): these are
/// refused. Joins that hang together, or touch the same face, are one operation.
///
/// @param joins  Each edge once at most, no busy vertex.
void add_weld_operations(WeldStage& stage, std::vector<WeldJoin> joins);

}  // namespace meshalyzer
