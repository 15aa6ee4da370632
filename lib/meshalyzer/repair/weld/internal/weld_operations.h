#pragma once

#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/weld/internal/weld_classes.h"
#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): from joins to edits.

/// What the stages of a weld have in common.
struct WeldState {
  const WeldRules& rules;
  std::span<const WeldEdge> edges;
  /// #V: vertices of faces that an operation touches already; their edges wait for the next time.
  std::vector<std::uint8_t> is_busy;
  PassResult result;
};

/// Notes that a pair of edges is left as it is.
void refuse(WeldState& state, const WeldJoin& join, std::string_view reason);

/// Makes operations of the joins that check_merges() accepts; the others are refused. Joins that
/// hang together, or touch the same face, are one operation.
///
/// @param joins  Each edge once at most, no busy vertex.
void add_weld_operations(WeldState& state, std::vector<WeldJoin> joins);

}  // namespace meshalyzer
