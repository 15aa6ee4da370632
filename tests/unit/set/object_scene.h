#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/set/measure_separation.h"
#include "meshalyzer/set/object_cache.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace meshalyzer::test {

/// Soups as the objects of a set, by number.
class ObjectScene {
 public:
  explicit ObjectScene(std::vector<Soup> soups,
                       std::uint64_t byte_limit = std::numeric_limits<std::uint64_t>::max())
      : soups_(std::move(soups)), cache_(soups_.size(), byte_limit, [this](std::size_t i) {
          return std::make_unique<const SetObject>(soups_[i], ClosestUse::Prepared);
        }) {
    for (const Soup& soup : soups_) {
      boxes_.push_back(SetObject(soup).box());
    }
  }

  [[nodiscard]] ObjectSeparation measure(Index object, const SeparationOptions& options = {}) {
    const BoxTree tree(boxes_);
    return measure_separation(object, {.boxes = boxes_, .tree = tree, .objects = cache_}, options);
  }
  [[nodiscard]] const std::vector<Soup>& soups() const { return soups_; }
  [[nodiscard]] ObjectCache& cache() { return cache_; }

 private:
  std::vector<Soup> soups_;
  std::vector<Box3> boxes_;
  ObjectCache cache_;
};

}  // namespace meshalyzer::test
