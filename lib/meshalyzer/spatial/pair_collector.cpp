#include "meshalyzer/spatial/pair_collector.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace meshalyzer {
namespace {

std::uint64_t key_of(const IntersectingPair& pair) {
  return std::uint64_t{pair.face_a} << 32U | pair.face_b;
}

bool comes_before(const IntersectingPair& a, const IntersectingPair& b) {
  return key_of(a) < key_of(b);
}

/// The number of pairs of a product that are listed at a time.
constexpr std::size_t kPairsAtOnce = 4096;

/// Calls `visit` with the pairs of a product, ascending, until it returns false.
template <typename Visit>
void for_each_ascending(const PairProduct& product, const Visit& visit) {
  const std::span<const Index> a = product.a;
  const std::span<const Index> b = product.b;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    const Index lower = std::min(a[i], b[j]);
    if (product.is_within_one()) j = i + 1;
    const std::span<const Index> higher = lower == a[i] ? b.subspan(j) : a.subspan(i);
    for (const Index face : higher) {
      if (!visit(IntersectingPair{lower, face, product.kind})) return;
    }
    ++(lower == a[i] ? i : j);
  }
}

}  // namespace

void PairCollector::on_pairs(std::span<const IntersectingPair> pairs) {
  ContactCounts counts;
  counts.add(pairs);
  list(pairs, counts);
}

void PairCollector::on_product(const PairProduct& product) {
  ContactCounts counts;
  counts.add(product.kind, product.n_pairs());
  list({}, counts);
  std::size_t n_left = max_listed_;
  std::vector<IntersectingPair> some;
  for_each_ascending(product, [&](const IntersectingPair& pair) {
    if (n_left == 0 || key_of(pair) >= end_.load(std::memory_order_relaxed)) return false;
    --n_left;
    some.push_back(pair);
    if (some.size() == kPairsAtOnce) {
      list(some, {});
      some.clear();
    }
    return true;
  });
  list(some, {});
}

/// Lists the given pairs that are among the first, and adds to the counts.
void PairCollector::list(std::span<const IntersectingPair> pairs, const ContactCounts& counts) {
  // Most pairs of a long search are not among the first: they are removed before the lock is taken.
  const std::uint64_t end = end_.load(std::memory_order_relaxed);
  std::vector<IntersectingPair> first;
  if (max_listed_ != 0) {
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(first),
                 [&](const IntersectingPair& pair) { return key_of(pair) < end; });
  }
  const std::lock_guard lock(mutex_);
  counts_.add(counts);
  pairs_.insert(pairs_.end(), first.begin(), first.end());
  if (pairs_.size() / 2 >= max_listed_ && !pairs_.empty()) drop_last();
}

void PairCollector::drop_last() {
  const auto end = pairs_.begin() + static_cast<std::ptrdiff_t>(max_listed_);
  std::nth_element(pairs_.begin(), end, pairs_.end(), comes_before);
  end_.store(key_of(*end), std::memory_order_relaxed);
  pairs_.erase(end, pairs_.end());
}

FoundPairs PairCollector::take() {
  if (pairs_.size() > max_listed_) drop_last();
  std::sort(pairs_.begin(), pairs_.end(), comes_before);
  pairs_.shrink_to_fit();
  return {.listed = std::move(pairs_), .counts = counts_};
}

void PairBuffer::flush() {
  if (!pairs_.empty()) listener_->on_pairs(pairs_);
  pairs_.clear();
}

}  // namespace meshalyzer
