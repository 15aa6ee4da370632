#pragma once

#include "meshalyzer/report/key_ids.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// Places that a pass left for one and the same reason.
struct RefusalGroup {
  /// Pass, code and reason of all of them.
  const LoggedRefusal* like = nullptr;
  /// Index into RepairReport::meshes; absent where the elements are gone.
  std::optional<std::size_t> mesh = std::nullopt;
  /// The number of different places, however often each was looked at.
  std::size_t places = 0;
  /// The ids that name the places, ascending: those of their vertices in the output, or of the
  /// faces where a place has no such vertex.
  std::vector<std::int64_t> vertices = {};
  std::vector<std::int64_t> faces = {};
};

/// Returns the refusals of a repair by mesh, pass, code and reason, in the order of the log.
[[nodiscard]] std::vector<RefusalGroup> group_refusals(const RepairReport& report,
                                                       const KeyIds& ids);

}  // namespace meshalyzer
