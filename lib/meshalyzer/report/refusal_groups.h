#pragma once

#include "meshalyzer/report/key_ids.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// The places that a pass left unchanged for the same reason.
struct RefusalGroup {
  /// The first of these refusals; all have its pass, code and reason.
  const LoggedRefusal* first = nullptr;
  /// The index into RepairReport::meshes; absent if the elements were removed.
  std::optional<std::size_t> mesh = std::nullopt;
  /// The number of different places, each counted once.
  std::size_t places = 0;
  /// The ids that name the places, ascending: those of their vertices in the output, or of the
  /// faces if a place has no such vertex.
  std::vector<std::int64_t> vertices = {};
  std::vector<std::int64_t> faces = {};
};

/// Returns the refusals of a repair by mesh, pass, code and reason, in the order of the log.
[[nodiscard]] std::vector<RefusalGroup> group_refusals(const RepairReport& report,
                                                       const KeyIds& ids);

}  // namespace meshalyzer
