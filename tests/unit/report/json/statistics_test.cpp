#include "meshalyzer/report/json/statistics.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/report/json/non_finite.h"
#include "support/constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string json_of(const Statistics& statistics) {
  JsonWriter writer;
  write_statistics(writer, statistics);
  return writer.take();
}

std::string json_of(const Summary& summary) {
  JsonWriter writer;
  write_summary(writer, summary);
  return writer.take();
}

Statistics read_back(const Statistics& statistics) {
  return read_statistics(JsonTree(json_of(statistics)).root());
}

TEST(ReadStatistics, EveryFigureAndBinComesBackBitByBit) {
  std::vector<double> values{0.1, 1.0 / 3.0, 5e-324, 1e300, kInfinity};
  const Statistics written = summarize(values);
  const Statistics read = read_back(written);
  EXPECT_EQ(read.count, 4U);
  EXPECT_EQ(read.infinite, 1U);
  EXPECT_EQ(read.min, 5e-324);
  EXPECT_EQ(read.max, 1e300);
  EXPECT_EQ(read.mean, written.mean);
  EXPECT_EQ(read.median, written.median);
  EXPECT_EQ(read.total, written.total);
  EXPECT_EQ(read.histogram.edges, written.histogram.edges);
  EXPECT_EQ(read.histogram.counts, written.histogram.counts);
  EXPECT_EQ(json_of(read), json_of(written));
}

TEST(ReadStatistics, FigureThatOverflowedIsTheSameInfinityAgain) {
  Statistics written;
  written.count = 2;
  written.variance = kInfinity;
  written.total = -kInfinity;
  written.mean = std::copysign(kNan, -1.0);
  const Statistics read = read_back(written);
  EXPECT_EQ(read.variance, kInfinity);
  EXPECT_EQ(read.total, -kInfinity);
  EXPECT_TRUE(std::isnan(read.mean));
  EXPECT_TRUE(std::signbit(read.mean));  // fmt prints the sign
}

TEST(ReadStatistics, OfNothingAreThoseOfNothing) {
  EXPECT_EQ(json_of(read_back({})), json_of(Statistics{}));
}

TEST(ReadStatistics, HistogramOfOtherThanSixteenBinsIsRefused) {
  Statistics written;
  written.count = 1;
  std::string text = json_of(written);
  text.erase(text.find("[0, 0") + 1, 2);
  EXPECT_THROW(static_cast<void>(read_statistics(JsonTree(text).root())), InvalidArgument);
  text.insert(text.find("[ 0") + 1, "0, 0, 0,");
  EXPECT_THROW(static_cast<void>(read_statistics(JsonTree(text).root())), InvalidArgument);
}

TEST(ReadSummary, EveryFigureComesBack) {
  const Summary written{7, 2, 1.5, 9.25, 4.0, 3.5, 0.125, 28.0};
  const Summary read = read_summary(JsonTree(json_of(written)).root());
  EXPECT_EQ(read.count, 7U);
  EXPECT_EQ(read.infinite, 2U);
  EXPECT_EQ(read.min, 1.5);
  EXPECT_EQ(read.max, 9.25);
  EXPECT_EQ(read.mean, 4.0);
  EXPECT_EQ(read.median, 3.5);
  EXPECT_EQ(read.variance, 0.125);
  EXPECT_EQ(read.total, 28.0);
}

TEST(ReadReal, NullThatNothingExplainsIsRefused) {
  const JsonTree unexplained(R"({"area": null})");
  EXPECT_THROW(static_cast<void>(read_real(unexplained.root(), "area")), InvalidArgument);
  const JsonTree other(R"({"area": null, "non_finite": {"volume": "inf"}})");
  EXPECT_THROW(static_cast<void>(read_real(other.root(), "area")), InvalidArgument);
}

TEST(ReadReal, FiniteNumberIsNoExplanation) {
  for (const char* text : {R"("1")", R"("")", R"("infinite")", "1", "null"}) {
    const JsonTree tree(std::string(R"({"area": null, "non_finite": {"area": )") + text + "}}");
    EXPECT_THROW(static_cast<void>(read_real(tree.root(), "area")), InvalidArgument) << text;
  }
}

TEST(WriteNonFinite, FiniteRealsHaveNoMember) {
  JsonWriter writer;
  writer.begin_object(JsonLayout::Row);
  write_non_finite(writer, {{"area", 1e308}, {"volume", -0.0}});
  writer.end_object();
  EXPECT_EQ(writer.take(), "{}\n");
}

TEST(WriteNonFinite, OnlyThoseThatAreNotFiniteAreNamed) {
  JsonWriter writer;
  writer.begin_object(JsonLayout::Row);
  write_non_finite(writer, {{"a", 1.0}, {"b", kInfinity}, {"c", -kInfinity}, {"d", kNan}});
  writer.end_object();
  EXPECT_EQ(writer.take(), "{\"non_finite\": {\"b\": \"inf\", \"c\": \"-inf\", \"d\": \"nan\"}}\n");
}

}  // namespace
}  // namespace meshalyzer
