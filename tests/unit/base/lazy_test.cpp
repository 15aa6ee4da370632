#include "meshalyzer/base/lazy.h"

#include "meshalyzer/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace meshalyzer {
namespace {

TEST(Lazy, MakesNothingUntilAsked) {
  Lazy<int> lazy;
  int n_made = 0;
  const auto make = [&] { return ++n_made; };
  EXPECT_EQ(n_made, 0);
  EXPECT_EQ(lazy.get(make), 1);
  EXPECT_EQ(lazy.get(make), 1);
  EXPECT_EQ(n_made, 1);
}

TEST(Lazy, AllThreadsGetTheOneValue) {
  Lazy<int> lazy;
  std::atomic<int> n_made = 0;
  std::vector<const int*> seen(8);
  std::vector<std::thread> threads;
  for (const int*& each : seen) {
    threads.emplace_back([&] { each = &lazy.get([&] { return ++n_made; }); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(n_made, 1);
  for (const int* each : seen) EXPECT_EQ(each, seen[0]);
}

TEST(Lazy, TasksOfALoopMayAskForWhatIsMadeByALoop) {
  // Each thread that waits for the end of the inner loop could take up a task of the outer one,
  // which asks for the value that the thread itself is making.
  for (int i = 0; i < 200; ++i) {
    Lazy<int> lazy;
    std::atomic<int> sum = 0;
    parallel_chunks(16, 1, [&](Chunk) {
      sum += lazy.get([] {
        std::atomic<int> n = 0;
        parallel_chunks(64, 1, [&](Chunk) {
          std::this_thread::yield();
          ++n;
        });
        return n.load();
      });
    });
    EXPECT_EQ(sum, 16 * 64);
  }
}

TEST(Lazy, IsMadeAgainAfterAFailure) {
  Lazy<int> lazy;
  EXPECT_THROW(lazy.get([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(lazy.get([] { return 7; }), 7);
}

TEST(Lazy, ValueCanBeTakenAway) {
  Lazy<std::vector<int>> lazy;
  const int* data = lazy.get([] { return std::vector<int>{1, 2}; }).data();
  const std::vector<int> taken = lazy.take();
  EXPECT_EQ(taken.data(), data);
}

}  // namespace
}  // namespace meshalyzer
