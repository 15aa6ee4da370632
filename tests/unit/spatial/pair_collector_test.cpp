#include "meshalyzer/spatial/pair_collector.h"

#include "meshalyzer/base/parallel.h"
#include "unit/spatial/pairs_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <tuple>
#include <vector>

namespace meshalyzer {
namespace {

/// All pairs of n faces, in any order, their kinds in turn.
Pairs all_pairs(Index n) {
  Pairs pairs;
  for (Index a = 0; a < n; ++a) {
    for (Index b = a + 1; b < n; ++b) {
      pairs.push_back({a, b, kContactKinds[pairs.size() % kContactKinds.size()]});
    }
  }
  std::mt19937 random(1);
  for (std::size_t i = pairs.size(); i > 1; --i) std::swap(pairs[i - 1], pairs[random() % i]);
  return pairs;
}

/// The first pairs of a list, sorted.
Pairs first(Pairs pairs, std::size_t n) {
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return std::tie(a.face_a, a.face_b) < std::tie(b.face_a, b.face_b);
  });
  pairs.resize(std::min(n, pairs.size()));
  return pairs;
}

FoundPairs collected(const Pairs& pairs, std::size_t max_listed, std::size_t n_at_once) {
  PairCollector collector(max_listed);
  parallel_chunks(pairs.size(), n_at_once, [&](Chunk chunk) {
    collector.on_pairs(std::span(pairs).subspan(chunk.begin, chunk.end - chunk.begin));
  });
  return collector.take();
}

TEST(PairCollector, ListsTheFirstAndCountsAll) {
  const Pairs pairs = all_pairs(60);  // 1770, a sixth of each kind
  for (const std::size_t n_threads : {1, 2, 5}) {
    const ThreadLimit limit(n_threads);
    for (const std::size_t max_listed : {0, 1, 2, 7, 100, 1769, 1770, 5000}) {
      for (const std::size_t n_at_once : {1, 13, 1770}) {
        const FoundPairs found = collected(pairs, max_listed, n_at_once);
        EXPECT_EQ(found.listed, first(pairs, max_listed)) << max_listed << " " << n_at_once;
        EXPECT_EQ(found.counts.total(), 1770U);
        EXPECT_EQ(found.counts.of(ContactKind::Crossing), 295U);
      }
    }
  }
}

TEST(PairCollector, ListsAllWhereThereIsNoLimit) {
  const Pairs pairs = all_pairs(20);
  EXPECT_EQ(collected(pairs, kAllPairs, 10).listed, first(pairs, pairs.size()));
}

/// All pairs of a product, ascending.
Pairs enumerated(const PairProduct& product) {
  Pairs pairs;
  for (const Index a : product.a) {
    for (const Index b : product.b) {
      if (!product.is_within_one() || a < b) {
        pairs.push_back({std::min(a, b), std::max(a, b), product.kind});
      }
    }
  }
  return first(pairs, pairs.size());
}

TEST(PairCollector, ListsTheFirstOfProductsToo) {
  const std::vector<Index> a{1, 4, 5, 9, 12, 30};
  const std::vector<Index> b{0, 2, 7, 8, 31};
  const std::vector<Index> one{6};
  const std::vector<PairProduct> products{{a, b, ContactKind::Crossing},
                                          {a, a, ContactKind::Duplicate},
                                          {one, a, ContactKind::Touching},
                                          {b, one, ContactKind::Touching}};
  Pairs all;
  for (const PairProduct& product : products) {
    const Pairs pairs = enumerated(product);
    EXPECT_EQ(pairs.size(), product.n_pairs());
    all.insert(all.end(), pairs.begin(), pairs.end());
  }
  for (std::size_t max_listed = 0; max_listed < all.size() + 2; ++max_listed) {
    PairCollector collector(max_listed);
    for (const PairProduct& product : products) collector.on_product(product);
    const FoundPairs found = collector.take();
    EXPECT_EQ(found.listed, first(all, max_listed));
    EXPECT_EQ(found.counts.of(ContactKind::Duplicate), 15U);
    EXPECT_EQ(found.counts.total(), 30U + 15U + 6U + 5U);
  }
}

TEST(PairCollector, NothingIsFoundWhereNothingCame) {
  const FoundPairs found = PairCollector(10).take();
  EXPECT_TRUE(found.listed.empty());
  EXPECT_EQ(found.counts, ContactCounts());
}

TEST(PairBuffer, HandsOnWhatIsLeft) {
  struct Taker : PairListener {
    Pairs taken;
    void on_pairs(std::span<const IntersectingPair> pairs) override {
      EXPECT_LE(pairs.size(), 4U);
      taken.insert(taken.end(), pairs.begin(), pairs.end());
    }
    void on_product(const PairProduct& /*product*/) override { ADD_FAILURE(); }
  } taker;
  const Pairs pairs = all_pairs(5);  // 10: two portions of 4, and 2
  PairBuffer buffer(taker, 4);
  for (const IntersectingPair& pair : pairs) buffer.push(pair);
  EXPECT_EQ(taker.taken.size(), 8U);
  buffer.flush();
  EXPECT_EQ(taker.taken, pairs);
  EXPECT_EQ(buffer.n_pushed(), 10U);
}

}  // namespace
}  // namespace meshalyzer
