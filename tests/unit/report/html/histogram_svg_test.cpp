#include "meshalyzer/report/html/histogram_svg.h"

#include "support/html_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <vector>

namespace meshalyzer {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Bar {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
  std::string title;
};

/// Bins of width 0.5 from 1.
Histogram histogram_of(const std::array<std::size_t, Histogram::kBins>& counts) {
  Histogram histogram;
  for (std::size_t i = 0; i <= Histogram::kBins; ++i) {
    histogram.edges[i] = 1.0 + 0.5 * static_cast<double>(i);
  }
  histogram.counts = counts;
  return histogram;
}

std::string drawing_of(const Histogram& histogram) {
  HtmlWriter html;
  append_histogram_svg(html, "edge <length>", histogram);
  return html.html();
}

std::vector<Bar> bars_of(const std::string& svg) {
  const std::regex pattern(
      "<rect class=\"bar\" x=\"([^\"]*)\" y=\"([^\"]*)\" width=\"([^\"]*)\" "
      "height=\"([^\"]*)\"[^>]*>"
      "\\s*<title>([^<]*)</title></rect>");
  std::vector<Bar> bars;
  for (std::sregex_iterator match(svg.begin(), svg.end(), pattern), end; match != end; ++match) {
    bars.push_back({std::stod((*match)[1]), std::stod((*match)[2]), std::stod((*match)[3]),
                    std::stod((*match)[4]), (*match)[5]});
  }
  return bars;
}

TEST(AppendHistogramSvg, HeightsAreProportionalToCounts) {
  const std::vector<Bar> bars =
      bars_of(drawing_of(histogram_of({8, 0, 4, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6})));
  ASSERT_EQ(bars.size(), 5U);
  ASSERT_GT(bars[0].height, 50.0);
  const std::vector<double> shares{1.0, 0.5, 0.25, 0.125, 0.75};
  for (std::size_t i = 0; i < bars.size(); ++i) {
    // Coordinates have six digits.
    EXPECT_NEAR(bars[i].height, shares[i] * bars[0].height, 1e-3);
  }
}

TEST(AppendHistogramSvg, BarsStandSideBySideOnOneLine) {
  const std::vector<Bar> bars =
      bars_of(drawing_of(histogram_of({3, 1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3, 4, 5, 6})));
  ASSERT_EQ(bars.size(), Histogram::kBins);
  const double pitch = bars[1].x - bars[0].x;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    EXPECT_NEAR(bars[i].y + bars[i].height, bars[0].y + bars[0].height, 1e-3);
    EXPECT_NEAR(bars[i].x, bars[0].x + pitch * static_cast<double>(i), 1e-2);
    EXPECT_GT(bars[i].width, 0.5 * pitch);
    EXPECT_LT(bars[i].width, pitch);
    EXPECT_GE(bars[i].y, 0.0);
  }
}

TEST(AppendHistogramSvg, CountsHaveTheirDigitsInGroups) {
  const std::string svg = drawing_of(histogram_of({20'000, 1'234}));
  EXPECT_THAT(svg, HasSubstr("at most 20,000 in a bin"));
  EXPECT_THAT(svg, HasSubstr(">10,000</text>"));
  EXPECT_EQ(bars_of(svg)[1].title, "1.5 .. 2: 1,234");
}

TEST(AppendHistogramSvg, EachBarTellsItsBinAndCount) {
  const std::vector<Bar> bars =
      bars_of(drawing_of(histogram_of({0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1})));
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_EQ(bars[0].title, "2 .. 2.5: 7");
  EXPECT_EQ(bars[1].title, "8.5 .. 9: 1");
}

TEST(AppendHistogramSvg, LinesStandAtRoundCountsAtTheirHeight) {
  const std::string svg =
      drawing_of(histogram_of({400, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 100}));
  const std::vector<Bar> bars = bars_of(svg);
  ASSERT_EQ(bars.size(), 2U);
  // The steps are hundreds: 400 / 100 is below 5, and 400 / 50 is not.
  const std::regex line(
      "<line class=\"grid\"[^>]* y1=\"([^\"]*)\"[^>]*></line><text [^>]*>([0-9]+)<");
  std::vector<std::pair<double, std::string>> lines;
  for (std::sregex_iterator match(svg.begin(), svg.end(), line), end; match != end; ++match) {
    lines.emplace_back(std::stod((*match)[1]), (*match)[2]);
  }
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].second, "100");
  EXPECT_NEAR(lines[0].first, bars[1].y, 1e-3);
  EXPECT_EQ(lines[3].second, "400");
  EXPECT_NEAR(lines[3].first, bars[0].y, 1e-3);
}

TEST(AppendHistogramSvg, ValuesStandBelow) {
  const std::string svg =
      drawing_of(histogram_of({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
  for (const char* label : {">1</text>", ">3</text>", ">5</text>", ">7</text>", ">9</text>"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
}

TEST(AppendHistogramSvg, LabelsThatAreLongStandAtTheEndsAlone) {
  Histogram histogram = histogram_of({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
  for (std::size_t i = 0; i <= Histogram::kBins; ++i) {
    histogram.edges[i] = 1.0 + 1e-14 * static_cast<double>(i);
  }
  const std::string svg = drawing_of(histogram);
  EXPECT_THAT(svg, HasSubstr("text-anchor=\"start\""));
  EXPECT_THAT(svg, Not(HasSubstr("text-anchor=\"middle\"")));
}

TEST(AppendHistogramSvg, DrawingHasANameAndIsWellFormed) {
  HtmlWriter html;
  html.markup("<!doctype html>\n<html><body><h1>x</h1>");
  append_histogram_svg(html, "edge <length>",
                       histogram_of({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3}));
  html.markup("</body></html>");
  EXPECT_THAT(test::html_faults(html.html()), testing::IsEmpty());
  EXPECT_THAT(html.html(), HasSubstr("role=\"img\" aria-label=\"Histogram of edge &lt;length&gt; "
                                     "from 1 to 9, at most 3 in a bin\""));
}

TEST(AppendHistogramSvg, LargeCountsStayInTheDrawing) {
  const std::vector<Bar> bars = bars_of(
      drawing_of(histogram_of({4'000'000'000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1})));
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_LT(bars[0].height, 170.0);
}

}  // namespace
}  // namespace meshalyzer
