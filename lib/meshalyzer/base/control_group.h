#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace meshalyzer {

/// Names the places where Linux describes the control groups of a process.
struct ControlGroupPlaces {
  /// Lines `number:controllers:path`, as `man 7 cgroups` says.
  std::string own_groups = "/proc/self/cgroup";
  /// The folder that the hierarchies are mounted in.
  std::string root = "/sys/fs/cgroup";
};

/// Returns the smallest memory limit, in bytes, of the control groups that this process is in and
/// of their parent groups, of version 1 and 2, or nothing when none is set. A file that cannot be
/// read sets no limit.
[[nodiscard]] std::optional<std::uint64_t> control_group_memory(const ControlGroupPlaces& places);

}  // namespace meshalyzer
