#include "meshalyzer/base/pooled_values.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "support/file_size_limit.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The smallest buffer there is: one chunk.
constexpr std::size_t kSmallBuffer = kChunkLength * sizeof(double);

PooledValues pooled(const std::vector<double>& values, std::size_t buffer_bytes = kSmallBuffer) {
  PooledValues pool(buffer_bytes);
  pool.append(values);
  return pool;
}

std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

void expect_same(const Statistics& got, const Statistics& want) {
  EXPECT_EQ(got.count, want.count);
  EXPECT_EQ(got.infinite, want.infinite);
  EXPECT_EQ(bits_of(got.min), bits_of(want.min));
  EXPECT_EQ(bits_of(got.max), bits_of(want.max));
  EXPECT_EQ(bits_of(got.mean), bits_of(want.mean));
  EXPECT_EQ(bits_of(got.median), bits_of(want.median));
  EXPECT_EQ(bits_of(got.variance), bits_of(want.variance));
  EXPECT_EQ(bits_of(got.total), bits_of(want.total));
  EXPECT_EQ(got.histogram.edges, want.histogram.edges);
  EXPECT_EQ(got.histogram.counts, want.histogram.counts);
}

void expect_as_summarize(std::vector<double> values) {
  const Statistics got = pooled(values).summarize();
  expect_same(got, summarize(values));
}

template <typename Value>
std::vector<double> made(std::size_t n, Value&& value) {
  std::vector<double> values(n);
  std::generate(values.begin(), values.end(), value);
  return values;
}

std::vector<double> skewed(std::size_t n) {
  std::mt19937_64 random(31);
  std::lognormal_distribution<double> distribution(0.0, 3.0);
  return made(n, [&] { return distribution(random); });
}

/// While it lives, temporary files go to this folder.
class TemporaryFilesIn {
 public:
  explicit TemporaryFilesIn(const std::string& folder) {
    const char* old = std::getenv("TMPDIR");
    old_ = old == nullptr ? std::nullopt : std::optional<std::string>(old);
    ::setenv("TMPDIR", folder.c_str(), 1);
  }
  ~TemporaryFilesIn() { old_ ? ::setenv("TMPDIR", old_->c_str(), 1) : ::unsetenv("TMPDIR"); }
  TemporaryFilesIn(const TemporaryFilesIn&) = delete;
  TemporaryFilesIn& operator=(const TemporaryFilesIn&) = delete;

 private:
  std::optional<std::string> old_;
};

TEST(PooledValues, OfNoValuesAreZeros) {
  expect_same(PooledValues().summarize(), Statistics{});
}

TEST(PooledValues, InTheBufferAreSummarizedAsAList) {
  expect_as_summarize({3.5});
  expect_as_summarize({9, 1, 5, 4});
  expect_as_summarize({9, 1, 5, 4, 100});
}

TEST(PooledValues, BeyondTheBufferAreSummarizedAsAList) {
  // Odd and even, and both sides of where the buffer spills and a block of reading ends.
  for (const std::size_t chunks : {1U, 2U, 16U, 17U, 33U}) {
    for (const std::size_t more : {0U, 1U, 2U, 4001U}) {
      expect_as_summarize(skewed(chunks * kChunkLength - 1 + more));
    }
  }
}

TEST(PooledValues, OfAnyBitsAreSummarizedAsAList) {
  // Both signs, denormals and the ends of the range; sums overflow, which both must do alike.
  std::mt19937_64 random(32);
  expect_as_summarize(
      made(100001, [&] { return std::bit_cast<double>(random() & ~(1ULL << 62U)); }));
  expect_as_summarize(made(100000, [&] { return std::bit_cast<double>(random() | 1ULL << 63U); }));
}

TEST(PooledValues, WhoseSumsCancelAreSummarizedAsAList) {
  // What is left of the total is far below what compensation can hold of such magnitudes: its
  // digits show the order and grouping of the additions.
  std::mt19937_64 random(36);
  std::normal_distribution<double> exponent(0.0, 30.0);
  std::vector<double> values = made(40000, [&] { return std::exp(exponent(random)); });
  for (std::size_t i = 0; i < 40000; ++i) {
    values.push_back(-values[i]);
  }
  std::shuffle(values.begin(), values.end(), random);
  values.push_back(1.0);
  const Statistics got = pooled(values, kSmallBuffer * 3 / 2).summarize();
  expect_same(got, summarize(values));
}

TEST(PooledValues, ThatDifferInTheLastBitsAloneHaveTheirMedian) {
  // Selection must go down to the last digit of the keys: 60,000 equal values amidst neighbours.
  std::mt19937_64 random(33);
  const std::uint64_t one = bits_of(1.0);
  expect_as_summarize(made(100000, [&] {
    const std::uint64_t choice = random() % 10;
    return std::bit_cast<double>(choice < 6 ? one : one + choice);
  }));
}

TEST(PooledValues, AllEqualHaveThatMedian) {
  expect_as_summarize(std::vector<double>(50000, 0.1));
  expect_as_summarize(std::vector<double>(50001, -0.1));
}

TEST(PooledValues, MedianOfTwoEqualHalvesIsBetweenThem) {
  // The two middle values lie in two parts of the selection, far from each other.
  std::vector<double> values(60000, 3.0);
  std::fill(values.begin(), values.begin() + 30000, -1.0);
  std::shuffle(values.begin(), values.end(), std::mt19937_64(34));
  EXPECT_EQ(pooled(values).summarize().median, 1.0);  // (-1 + 3) / 2
  expect_as_summarize(values);
}

TEST(PooledValues, ZerosOfBothSignsHaveThePlainZeroAsMedian) {
  std::vector<double> values(40000, -0.0);
  std::fill(values.begin(), values.begin() + 10000, 0.0);
  EXPECT_EQ(bits_of(pooled(values).summarize().median), bits_of(0.0));
  expect_as_summarize(values);
}

TEST(PooledValues, InfinitiesAreCountedApart) {
  std::vector<double> values = skewed(30000);
  for (std::size_t i = 0; i < values.size(); i += 7) {
    values[i] = std::copysign(std::numeric_limits<double>::infinity(), i % 2 == 0 ? 1.0 : -1.0);
  }
  EXPECT_EQ(pooled(values).summarize().infinite, 4286U);  // ceil(30000 / 7)
  expect_as_summarize(values);
}

TEST(PooledValues, HowTheyAreSharedOutMakesNoDifference) {
  const std::vector<double> values = skewed(70001);
  const Statistics at_once = pooled(values).summarize();
  PooledValues pool(kSmallBuffer);
  std::mt19937_64 random(35);
  for (std::size_t begin = 0; begin < values.size();) {
    const std::size_t length = std::min<std::size_t>(random() % 9000, values.size() - begin);
    pool.append(std::span(values).subspan(begin, length));
    begin += length;
  }
  expect_same(pool.summarize(), at_once);
}

TEST(PooledValues, TheSizeOfTheBufferMakesNoDifference) {
  const std::vector<double> values = skewed(70001);
  const Statistics small = pooled(values).summarize();
  expect_same(pooled(values, 0).summarize(), small);
  expect_same(pooled(values, 3 * kSmallBuffer + 1).summarize(), small);
  expect_same(pooled(values, PooledValues::kDefaultBufferBytes).summarize(), small);
}

TEST(PooledValues, TheNumberOfThreadsMakesNoDifference) {
  const std::vector<double> values = skewed(70001);
  const Statistics many = pooled(values).summarize();
  const ThreadLimit limit(1);
  expect_same(pooled(values).summarize(), many);
}

TEST(PooledValues, CanBeSummarizedOnTheWay) {
  std::vector<double> values = skewed(50000);
  const std::span<const double> all = values;
  PooledValues pool(kSmallBuffer);
  pool.append(all.first(30001));
  std::vector<double> first(values.begin(), values.begin() + 30001);
  expect_same(pool.summarize(), summarize(first));
  pool.append(all.subspan(30001));
  expect_same(pool.summarize(), summarize(values));
}

TEST(PooledValues, GoOnWhereTheyAreMovedTo) {
  std::vector<double> values = skewed(20000);
  PooledValues first = pooled(values);
  PooledValues second = std::move(first);
  second.append(std::vector<double>{5.0});
  values.push_back(5.0);
  first = std::move(second);
  expect_same(first.summarize(), summarize(values));
}

TEST(PooledValues, LeaveNoNameInTheTemporaryFolder) {
  const TemporaryFolder folder;
  const TemporaryFilesIn there(folder.path());
  const PooledValues pool = pooled(skewed(50000));
  EXPECT_EQ(folder.n_entries(), 0);
}

TEST(PooledValues, NeedNoTemporaryFolderWhileTheBufferHoldsThem) {
  const TemporaryFilesIn nowhere("/none");
  EXPECT_NO_THROW(static_cast<void>(pooled(skewed(kChunkLength)).summarize()));
}

/// The message of the IoError that adding these values throws, or "accepted".
std::string append_error(PooledValues& pool, const std::vector<double>& values) {
  try {
    pool.append(values);
  } catch (const IoError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PooledValues, ATemporaryFolderThatIsNotThereIsNamed) {
  const TemporaryFilesIn nowhere("/none");
  PooledValues pool(kSmallBuffer);
  EXPECT_EQ(append_error(pool, skewed(20000)),
            "/none: a temporary file cannot be made: No such file or directory");
}

TEST(PooledValues, AFullDiskIsAnErrorThatSpoilsNothing) {
  const TemporaryFolder folder;
  const TemporaryFilesIn there(folder.path());
  std::vector<double> values = skewed(5 * kChunkLength);
  const std::span<const double> all = values;
  PooledValues pool(kSmallBuffer);
  pool.append(all.first(2 * kChunkLength));
  {
    // Room for half of what comes next: the second buffer is written in part.
    const FileSizeLimit limit(kSmallBuffer + kSmallBuffer / 2);
    EXPECT_EQ(append_error(pool, {values[2 * kChunkLength]}),
              folder.path() + ": a temporary file cannot be written: File too large");
  }
  pool.append(all.subspan(2 * kChunkLength));
  expect_same(pool.summarize(), summarize(values));
}

}  // namespace
}  // namespace meshalyzer
