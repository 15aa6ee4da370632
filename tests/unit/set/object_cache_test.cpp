#include "meshalyzer/set/object_cache.h"

#include "meshalyzer/base/error.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <limits>
#include <thread>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
using Pointer = std::shared_ptr<const SetObject>;

std::unique_ptr<const SetObject> cube(std::size_t) {
  return std::make_unique<const SetObject>(shapes::cube());
}

/// Cubes all, each as large as the other.
struct Cubes {
  explicit Cubes(std::uint64_t limit_in_cubes) : cache(20, limit_in_cubes * size, cube) {}

  /// Tells whether it had to be loaded.
  bool loads(std::size_t object) {
    const std::size_t before = cache.n_loads();
    (void)cache.get(object);
    return cache.n_loads() != before;
  }

  std::uint64_t size = SetObject(shapes::cube()).bytes();
  ObjectCache cache;
};

/// Asks for an object from so many threads at the same time.
template <typename Ask>
void ask_at_once(std::size_t n, const Ask& ask) {
  std::promise<void> begin;
  const std::shared_future<void> has_begun = begin.get_future().share();
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < n; ++i) {
    threads.emplace_back([&, i] {
      has_begun.wait();
      ask(i);
    });
  }
  begin.set_value();
  for (std::thread& thread : threads) {
    thread.join();
  }
}

TEST(ObjectCache, ObjectIsLoadedOnceWhereMemoryAllows) {
  Cubes cubes(20);
  EXPECT_TRUE(cubes.loads(3));
  EXPECT_TRUE(cubes.loads(4));
  EXPECT_FALSE(cubes.loads(3));
  EXPECT_FALSE(cubes.loads(4));
}

TEST(ObjectCache, EachNumberIsItsOwnObject) {
  ObjectCache cache(3, kNoLimit, [](std::size_t i) {
    return std::make_unique<const SetObject>(shapes::icosphere(i));
  });
  for (const std::size_t level : {2U, 0U, 1U, 2U}) {
    // 20 * 4^level faces.
    EXPECT_EQ(cache.get(level)->tree().n_faces(), std::size_t{20} << (2 * level));
  }
}

TEST(ObjectCache, WhatWasNotUsedForLongestIsForgottenFirst) {
  Cubes cubes(3);
  for (const std::size_t object : {0U, 1U, 2U}) {
    EXPECT_TRUE(cubes.loads(object));
  }
  EXPECT_FALSE(cubes.loads(0));
  // 1 goes for 3, then 2 for 4; 0 was used after them.
  EXPECT_TRUE(cubes.loads(3));
  EXPECT_FALSE(cubes.loads(0));
  EXPECT_TRUE(cubes.loads(4));
  EXPECT_FALSE(cubes.loads(0));
  EXPECT_FALSE(cubes.loads(3));
  EXPECT_TRUE(cubes.loads(1));
  EXPECT_TRUE(cubes.loads(2));
}

TEST(ObjectCache, WhatIsHeldIsNeverForgotten) {
  Cubes cubes(1);
  const Pointer held = cubes.cache.get(0);
  for (std::size_t object = 1; object < 10; ++object) {
    EXPECT_TRUE(cubes.loads(object));
  }
  EXPECT_EQ(cubes.cache.get(0), held);
  EXPECT_FALSE(cubes.loads(0));
}

TEST(ObjectCache, ObjectStaysValidAsLongAsItIsHeld) {
  Cubes cubes(0);
  std::vector<Pointer> held;
  for (std::size_t object = 0; object < 20; ++object) {
    held.push_back(cubes.cache.get(object));
  }
  for (const Pointer& object : held) {
    EXPECT_EQ(object->tree().n_faces(), 12U);
  }
}

TEST(ObjectCache, WhatIsAddedIsNotLoaded) {
  Cubes cubes(2);
  const Pointer made = cube(3);
  cubes.cache.add(3, made);
  EXPECT_EQ(cubes.cache.get(3), made);
  EXPECT_EQ(cubes.cache.n_loads(), 0U);
  // It is not replaced, nor counted twice: there is still memory for one more.
  cubes.cache.add(3, cube(3));
  EXPECT_EQ(cubes.cache.get(3), made);
  EXPECT_TRUE(cubes.loads(4));
  EXPECT_FALSE(cubes.loads(3));
}

TEST(ObjectCache, NothingIsAddedBeyondTheLimit) {
  Cubes cubes(2);
  for (std::size_t object = 0; object < 3; ++object) {
    cubes.cache.add(object, cube(object));
  }
  EXPECT_EQ(cubes.cache.peak_bytes(), 2 * cubes.size);
  EXPECT_FALSE(cubes.loads(0));
  EXPECT_FALSE(cubes.loads(1));
  EXPECT_TRUE(cubes.loads(2));
}

TEST(ObjectCache, PeakIsTheLimitAndWhatIsLoadedBeyondIt) {
  Cubes cubes(4);
  EXPECT_EQ(cubes.cache.peak_bytes(), 0U);
  (void)cubes.cache.get(0);
  EXPECT_EQ(cubes.cache.peak_bytes(), cubes.size);
  for (std::size_t round = 0; round < 60; ++round) {
    (void)cubes.cache.get(round % 20);
  }
  // The fifth is there before another one is forgotten.
  EXPECT_EQ(cubes.cache.peak_bytes(), 5 * cubes.size);
}

TEST(ObjectCache, WithoutMemoryOnlyTheLastAndTheNextAreThere) {
  Cubes cubes(0);
  for (std::size_t round = 0; round < 60; ++round) {
    EXPECT_TRUE(cubes.loads(round % 20));
  }
  EXPECT_EQ(cubes.cache.peak_bytes(), 2 * cubes.size);
}

TEST(ObjectCache, ThreadsThatAskAtOnceShareOneLoad) {
  ObjectCache cache(1, 0, [](std::size_t i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    return cube(i);
  });
  std::vector<Pointer> got(8);
  ask_at_once(got.size(), [&](std::size_t i) { got[i] = cache.get(0); });
  EXPECT_EQ(cache.n_loads(), 1U);
  for (const Pointer& object : got) {
    EXPECT_EQ(object, got.front());
  }
}

TEST(ObjectCache, DifferentObjectsAreLoadedAtTheSameTime) {
  std::promise<void> second_began;
  std::future<void> second = second_began.get_future();
  std::atomic<bool> met = false;
  ObjectCache cache(2, kNoLimit, [&](std::size_t i) {
    if (i == 0) {
      met = second.wait_for(std::chrono::seconds(20)) == std::future_status::ready;
    } else {
      second_began.set_value();
    }
    return cube(i);
  });
  ask_at_once(2, [&](std::size_t i) { (void)cache.get(i); });
  EXPECT_TRUE(met);
}

TEST(ObjectCache, LoadThatThrewCanBeTriedAgain) {
  int n_tries = 0;
  ObjectCache cache(1, kNoLimit, [&](std::size_t i) {
    if (++n_tries == 1) {
      throw IoError("a.mesh", {}, "is away");
    }
    return cube(i);
  });
  EXPECT_THROW((void)cache.get(0), IoError);
  EXPECT_EQ(cache.n_loads(), 0U);
  EXPECT_EQ(cache.get(0)->tree().n_faces(), 12U);
  EXPECT_EQ(cache.n_loads(), 1U);
}

TEST(ObjectCache, ThreadsThatWaitForALoadThatThrowsLoadThemselves) {
  std::atomic<int> n_tries = 0;
  ObjectCache cache(1, kNoLimit, [&](std::size_t i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (++n_tries == 1) {
      throw IoError("a.mesh", {}, "is away");
    }
    return cube(i);
  });
  std::atomic<int> n_thrown = 0;
  std::atomic<int> n_got = 0;
  ask_at_once(6, [&](std::size_t) {
    try {
      n_got += cache.get(0) ? 1 : 0;
    } catch (const IoError&) {
      ++n_thrown;
    }
  });
  EXPECT_EQ(n_thrown, 1);
  EXPECT_EQ(n_got, 5);
  EXPECT_EQ(n_tries, 2);
}

TEST(ObjectCache, ManyThreadsOverLittleMemoryAlwaysGetTheObjectTheyAskFor) {
  ObjectCache cache(4, 2 * SetObject(shapes::icosphere(1)).bytes(), [](std::size_t i) {
    return std::make_unique<const SetObject>(shapes::icosphere(i % 2));
  });
  std::atomic<int> n_wrong = 0;
  ask_at_once(4, [&](std::size_t thread) {
    for (std::size_t round = 0; round < 100; ++round) {
      const std::size_t object = (round * (thread + 1) + thread) % 4;
      n_wrong += cache.get(object)->tree().n_faces() == (object % 2 == 0 ? 20U : 80U) ? 0 : 1;
    }
  });
  EXPECT_EQ(n_wrong, 0);
}

TEST(ObjectCache, LoaderThatIsNullIsRefused) {
  EXPECT_THROW(ObjectCache(1, kNoLimit, nullptr), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
