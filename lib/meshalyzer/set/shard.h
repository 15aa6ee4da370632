#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// One of several equal parts of the work on a set, each done by a run of its own.
struct Shard {
  /// 0 ... count - 1.
  std::size_t number = 0;
  std::size_t count = 1;

  /// Tells whether the work on a single file is this shard's: files are dealt out in turn.
  [[nodiscard]] bool owns_file(std::size_t file) const { return file % count == number; }
};

/// The objects that belong to a shard in the work between objects: a run of neighbours in their
/// order in space. All shards have about the same number of faces.
struct ShardRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// @param order    As BoxTree::order() returns it.
/// @param n_faces  By object.
[[nodiscard]] ShardRange range_of(const Shard& shard, std::span<const Index> order,
                                  std::span<const std::size_t> n_faces);

}  // namespace meshalyzer
