#include "meshalyzer/base/parallel_in_order.h"

#include "meshalyzer/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::size_t kItems = 300;

std::vector<std::size_t> counted_to(std::size_t n) {
  std::vector<std::size_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

/// Works for a time that differs from item to item, so that later ones are often made first.
void work_unevenly(std::size_t i) {
  std::this_thread::sleep_for(std::chrono::microseconds(50 * (i * 7 % 11)));
}

/// The items in the order of their use, where each is made as its own number.
std::vector<std::size_t> used(std::size_t n, std::size_t at_once) {
  std::vector<std::size_t> order;
  parallel_in_order(
      n, at_once,
      [](std::size_t i) {
        work_unevenly(i);
        return 10 * i;
      },
      [&](std::size_t i, std::size_t made) {
        EXPECT_EQ(made, 10 * i);
        order.push_back(i);
        return Next::GoOn;
      });
  return order;
}

TEST(ParallelInOrder, UsesEachItemOnceInOrder) {
  for (const std::size_t at_once : {1U, 2U, 7U, 1000U}) {
    EXPECT_EQ(used(kItems, at_once), counted_to(kItems)) << at_once;
  }
}

TEST(ParallelInOrder, DoesTheSameWithOneThread) {
  const ThreadLimit limit(1);
  EXPECT_EQ(used(kItems, 5), counted_to(kItems));
}

TEST(ParallelInOrder, NoneAtOnceCountsAsOne) {
  EXPECT_EQ(used(3, 0), counted_to(3));
}

TEST(ParallelInOrder, OfNoItemsDoesNothing) {
  EXPECT_EQ(used(0, 4), counted_to(0));
}

TEST(ParallelInOrder, MakesItemsAtTheSameTime) {
  if (std::thread::hardware_concurrency() < 2) {
    GTEST_SKIP() << "needs two cores";
  }
  // Each of two items waits, not for ever, until both are being made.
  std::atomic<int> n_making = 0;
  const auto is_accompanied = [&](std::size_t) {
    ++n_making;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (n_making < 2 && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::yield();
    }
    return n_making == 2;
  };
  parallel_in_order(2, 2, is_accompanied, [](std::size_t, bool accompanied) {
    EXPECT_TRUE(accompanied);
    return Next::GoOn;
  });
}

TEST(ParallelInOrder, NoMoreThanAskedAreMadeAndUnused) {
  constexpr std::size_t kAtOnce = 3;
  std::atomic<std::size_t> n_alive = 0;
  std::atomic<bool> is_exceeded = false;
  parallel_in_order(
      kItems, kAtOnce,
      [&](std::size_t i) {
        if (++n_alive > kAtOnce) {
          is_exceeded = true;
        }
        work_unevenly(i);
        return i;
      },
      [&](std::size_t i, std::size_t) {
        work_unevenly(i + 5);
        --n_alive;
        return Next::GoOn;
      });
  EXPECT_FALSE(is_exceeded);
}

TEST(ParallelInOrder, NeverUsesTwoItemsAtATime) {
  std::atomic<bool> is_using = false;
  bool is_doubled = false;
  parallel_in_order(
      kItems, 8, [](std::size_t i) { return i; },
      [&](std::size_t i, std::size_t) {
        is_doubled = is_doubled || is_using.exchange(true);
        work_unevenly(i);
        is_using = false;
        return Next::GoOn;
      });
  EXPECT_FALSE(is_doubled);
}

/// Depth of items begun and not ended in a thread.
thread_local int depth_here = 0;

/// Runs a parallel loop inside an item.
/// @return whether the thread was in no other item.
bool is_alone_in_its_thread() {
  const bool is_alone = depth_here == 0;
  ++depth_here;
  parallel_chunks(16, 1, [](Chunk chunk) { work_unevenly(chunk.number); });
  --depth_here;
  return is_alone;
}

TEST(ParallelInOrder, AThreadThatWaitsInsideAnItemBeginsNoOther) {
  // It takes a third thread, and so a third core, for this to go wrong.
  std::size_t n_inside_others = 0;
  parallel_in_order(
      100, 16, [](std::size_t) { return is_alone_in_its_thread(); },
      [&](std::size_t, bool is_make_alone) {
        const bool is_use_alone = is_alone_in_its_thread();
        n_inside_others += is_make_alone && is_use_alone ? 0 : 1;
        return Next::GoOn;
      });
  EXPECT_EQ(n_inside_others, 0U);
}

TEST(ParallelInOrder, ItemsNeedNoCopy) {
  std::size_t sum = 0;
  parallel_in_order(
      4, 2, [](std::size_t i) { return std::make_unique<std::size_t>(i); },
      [&](std::size_t, std::unique_ptr<std::size_t> made) {
        sum += *made;
        return Next::GoOn;
      });
  EXPECT_EQ(sum, 6U);  // 0 + 1 + 2 + 3
}

TEST(ParallelInOrder, AnItemIsGoneBeforeItsPlaceIsTakenAgain) {
  const auto alive = std::make_shared<int>();
  bool is_gone = true;
  parallel_in_order(
      50, 1,
      [&](std::size_t) {
        is_gone = is_gone && alive.use_count() == 1;
        return alive;
      },
      [](std::size_t, const std::shared_ptr<int>&) { return Next::GoOn; });
  EXPECT_TRUE(is_gone);
  EXPECT_EQ(alive.use_count(), 1);
}

TEST(ParallelInOrder, StoppingUsesNoMoreAndSoonMakesNoMore) {
  constexpr std::size_t kLast = 20;
  constexpr std::size_t kAtOnce = 4;
  std::atomic<std::size_t> n_made = 0;
  std::vector<std::size_t> order;
  parallel_in_order(
      kItems, kAtOnce,
      [&](std::size_t i) {
        ++n_made;
        return i;
      },
      [&](std::size_t i, std::size_t) {
        order.push_back(i);
        return i == kLast ? Next::Stop : Next::GoOn;
      });
  EXPECT_EQ(order, counted_to(kLast + 1));
  EXPECT_LE(n_made, kLast + kAtOnce);
}

/// The message of what a run throws whose items `failing` and all later ones cannot be made, and
/// how many items were used before.
struct FailedRun {
  std::string message;
  std::size_t n_used = 0;
};

FailedRun run_with_failing_makes(std::size_t first_failing) {
  FailedRun run;
  try {
    parallel_in_order(
        kItems, 8,
        [&](std::size_t i) {
          // The first to fail is the slowest: others have failed before it.
          work_unevenly(i == first_failing ? 3 : 0);
          if (i >= first_failing) {
            throw std::runtime_error("item " + std::to_string(i));
          }
          return i;
        },
        [&](std::size_t, std::size_t) {
          ++run.n_used;
          return Next::GoOn;
        });
  } catch (const std::runtime_error& error) {
    run.message = error.what();
  }
  return run;
}

TEST(ParallelInOrder, OfFailedItemsTheFirstInOrderIsTold) {
  const FailedRun many = run_with_failing_makes(40);
  EXPECT_EQ(many.message, "item 40");
  EXPECT_EQ(many.n_used, 40U);
  const ThreadLimit limit(1);
  const FailedRun one = run_with_failing_makes(40);
  EXPECT_EQ(one.message, "item 40");
  EXPECT_EQ(one.n_used, 40U);
}

TEST(ParallelInOrder, AnItemThatFailsAfterTheStopIsNotTold) {
  EXPECT_NO_THROW(parallel_in_order(
      kItems, 8, [](std::size_t i) { return i <= 30 ? i : throw std::runtime_error("too late"); },
      [](std::size_t i, std::size_t) { return i == 30 ? Next::Stop : Next::GoOn; }));
}

TEST(ParallelInOrder, AFailedUseEndsAllAndIsRethrown) {
  std::size_t n_used = 0;
  const auto use = [&](std::size_t i, std::size_t) {
    ++n_used;
    return i < 9 ? Next::GoOn : throw std::runtime_error("use");
  };
  EXPECT_THROW(parallel_in_order(
                   kItems, 8, [](std::size_t i) { return i; }, use),
               std::runtime_error);
  EXPECT_EQ(n_used, 10U);
}

}  // namespace
}  // namespace meshalyzer
