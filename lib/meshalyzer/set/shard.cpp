#include "meshalyzer/set/shard.h"

#include <algorithm>

namespace meshalyzer {

ShardRange range_of(const Shard& shard, std::span<const Index> order,
                    std::span<const std::size_t> n_faces) {
  std::size_t total = 0;
  for (const Index object : order) {
    total += n_faces[object];
  }
  // An object belongs to the shard that contains the middle of its faces.
  ShardRange range{order.size(), order.size()};
  std::size_t before = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t middle = before + n_faces[order[i]] / 2;
    const std::size_t owner =
        std::min(middle * shard.count / std::max<std::size_t>(1, total), shard.count - 1);
    if (owner >= shard.number) {
      range.begin = std::min(range.begin, i);
    }
    if (owner > shard.number) {
      range.end = i;
      break;
    }
    before += n_faces[order[i]];
  }
  return range;
}

}  // namespace meshalyzer
