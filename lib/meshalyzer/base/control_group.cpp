#include "meshalyzer/base/control_group.h"

#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

namespace meshalyzer {
namespace {

using Path = std::filesystem::path;

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// Returns the number that is the content of a file, or kNoLimit when it holds no number ("max").
std::uint64_t limit_in(const Path& file) {
  std::string word;
  std::ifstream(file) >> word;
  const std::optional<std::int64_t> limit = parse_integer(word);
  return limit && *limit >= 0 ? static_cast<std::uint64_t>(*limit) : kNoLimit;
}

/// Returns the smallest limit of a group and those around it. Inside a container the group's own
/// path may not exist; the limit then stands at the root.
std::uint64_t smallest_limit(const Path& root, Path group, const char* file) {
  std::uint64_t limit = limit_in(root / file);
  for (; group.has_relative_path(); group = group.parent_path()) {
    limit = std::min(limit, limit_in(root / group.relative_path() / file));
  }
  return limit;
}

/// Tells whether "memory" is one of the words between the commas.
bool has_memory(std::string_view controllers) {
  std::string list = ",";
  list.append(controllers).append(",");
  return list.find(",memory,") != std::string::npos;
}

std::uint64_t limit_of_line(std::string_view line, const Path& root) {
  const std::size_t first = line.find(':');
  const std::size_t second = line.find(':', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) {
    return kNoLimit;
  }
  const std::string_view controllers = line.substr(first + 1, second - first - 1);
  const Path group(line.substr(second + 1));
  if (has_memory(controllers)) {
    return smallest_limit(root / "memory", group, "memory.limit_in_bytes");
  }
  return controllers.empty() ? smallest_limit(root, group, "memory.max") : kNoLimit;
}

}  // namespace

std::optional<std::uint64_t> control_group_memory(const ControlGroupPlaces& places) {
  std::uint64_t limit = kNoLimit;
  std::ifstream own_groups(places.own_groups);
  for (std::string line; std::getline(own_groups, line);) {
    limit = std::min(limit, limit_of_line(line, places.root));
  }
  return limit == kNoLimit ? std::nullopt : std::optional(limit);
}

}  // namespace meshalyzer
