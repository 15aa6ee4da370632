#include "meshalyzer/repair/driver/internal/removed_walls.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

/// Hashes corners; the hash does not depend on their order.
std::uint64_t hash_of(const Corners& corners) {
  std::uint64_t hash = 0;
  for (const Vec3& corner : corners) hash += hash_position(corner);
  return hash;
}

}  // namespace

void drop_walls(const Soup& input, std::span<const InteriorWall> walls,
                std::vector<ChangedFace>& faces) {
  if (walls.empty() || faces.empty()) return;
  using HashedFace = std::pair<std::uint64_t, Index>;
  std::vector<HashedFace> by_hash;
  by_hash.reserve(faces.size());
  for (const ChangedFace& changed : faces) {
    by_hash.emplace_back(hash_of(corners_of(input, changed.face)), changed.face);
  }
  std::sort(by_hash.begin(), by_hash.end());
  std::vector<Index> are_walls =
      collect_chunks<Index>(walls.size(), [&](Chunk chunk, std::vector<Index>& found) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
          const Corners& wall = walls[i].corners;
          const std::uint64_t hash = hash_of(wall);
          for (auto at = std::lower_bound(by_hash.begin(), by_hash.end(), HashedFace(hash, 0));
               at != by_hash.end() && at->first == hash; ++at) {
            if (is_same_surface(wall, corners_of(input, at->second))) found.push_back(at->second);
          }
        }
      });
  sort_unique(are_walls);
  std::erase_if(faces, [&](const ChangedFace& changed) {
    return std::binary_search(are_walls.begin(), are_walls.end(), changed.face);
  });
}

}  // namespace meshalyzer
