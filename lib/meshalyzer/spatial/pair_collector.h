#pragma once

#include "meshalyzer/spatial/pair_limits.h"
#include "meshalyzer/spatial/pair_listener.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <vector>

namespace meshalyzer {

/// Counts the pairs that the threads of a search find, and lists the first of them. The result
/// depends only on the pairs, not on their order of arrival.
class PairCollector : public PairListener {
 public:
  /// @param max_listed  The length of the list, which takes 24 bytes for each pair.
  explicit PairCollector(std::size_t max_listed) : max_listed_(max_listed) {}

  void on_pairs(std::span<const IntersectingPair> pairs) override;
  /// @complexity O(max_listed) at most, however many pairs there are.
  void on_product(const PairProduct& product) override;

  /// Returns the result, complete; the collector must not be used again.
  [[nodiscard]] FoundPairs take();

 private:
  void list(std::span<const IntersectingPair> pairs, const ContactCounts& counts);
  void drop_last();

  std::size_t max_listed_;
  /// Pairs from this key on are not among the first.
  std::atomic<std::uint64_t> end_ = std::numeric_limits<std::uint64_t>::max();
  std::mutex mutex_;
  std::vector<IntersectingPair> pairs_;
  ContactCounts counts_;
};

/// Buffers the pairs of one task, so that they are passed on in batches.
class PairBuffer {
 public:
  /// @param capacity  The number of pairs in a batch.
  PairBuffer(PairListener& listener, std::size_t capacity)
      : listener_(&listener), capacity_(capacity) {}

  void push(const IntersectingPair& pair) {
    pairs_.push_back(pair);
    ++n_pushed_;
    if (pairs_.size() == capacity_) flush();
  }

  void push(const PairProduct& product) {
    listener_->on_product(product);
    n_pushed_ += product.n_pairs();
  }

  /// Passes on the remaining pairs.
  void flush();

  /// Returns how many pairs were pushed in all.
  [[nodiscard]] std::size_t n_pushed() const { return n_pushed_; }

 private:
  PairListener* listener_;
  std::size_t capacity_;
  std::size_t n_pushed_ = 0;
  std::vector<IntersectingPair> pairs_;
};

}  // namespace meshalyzer
