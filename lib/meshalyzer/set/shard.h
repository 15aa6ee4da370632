#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// One of several equal parts of the work on a set, each done by a separate run.
struct Shard {
  /// The number of the shard, 0 ... count - 1.
  std::size_t number = 0;
  std::size_t count = 1;

  /// Tells whether a file belongs to this shard: files are distributed in turn.
  [[nodiscard]] bool owns_file(std::size_t file) const { return file % count == number; }
};

/// The objects that belong to a shard in the work between objects: a run of neighbours in the
/// spatial order. All shards have about the same number of faces.
struct ShardRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// @param order    The result of BoxTree::order().
/// @param n_faces  The number of faces of each object.
[[nodiscard]] ShardRange range_of(const Shard& shard, std::span<const Index> order,
                                  std::span<const std::size_t> n_faces);

}  // namespace meshalyzer
