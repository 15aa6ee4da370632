#include "meshalyzer/report/json/statistics.h"

#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

void write_figures(JsonWriter& json, const Summary& summary) {
  const auto figure = [&](double value) {
    return summary.count == 0 ? std::nullopt : std::optional(value);
  };
  json.member("count", summary.count);
  json.member("infinite", summary.infinite);
  json.member("min", figure(summary.min));
  json.member("max", figure(summary.max));
  json.member("mean", figure(summary.mean));
  json.member("median", figure(summary.median));
  json.member("variance", figure(summary.variance));
  json.member("total", figure(summary.total));
  write_non_finite(json, {{"min", summary.min},
                          {"max", summary.max},
                          {"mean", summary.mean},
                          {"median", summary.median},
                          {"variance", summary.variance},
                          {"total", summary.total}});
}

void write_histogram(JsonWriter& json, const Histogram& histogram) {
  json.begin_object();
  json.key("edges");
  json.begin_array(JsonLayout::Row);
  for (const double edge : histogram.edges) {
    json.value(edge);
  }
  json.end_array();
  json.key("counts");
  json.begin_array(JsonLayout::Row);
  for (const std::size_t count : histogram.counts) {
    json.value(count);
  }
  json.end_array();
  json.end_object();
}

}  // namespace

void write_statistics(JsonWriter& json, const Statistics& statistics) {
  json.begin_object();
  write_figures(json, statistics);
  json.key("histogram");
  if (statistics.count == 0) {
    json.null();
  } else {
    write_histogram(json, statistics.histogram);
  }
  json.end_object();
}

void write_summary(JsonWriter& json, const Summary& summary) {
  json.begin_object(JsonLayout::Row);
  write_figures(json, summary);
  json.end_object();
}

void write_non_finite(JsonWriter& json, std::initializer_list<NamedReal> reals) {
  const auto is_finite = [](const NamedReal& real) { return std::isfinite(real.value); };
  if (std::all_of(reals.begin(), reals.end(), is_finite)) {
    return;
  }
  json.key("non_finite");
  json.begin_object(JsonLayout::Row);
  for (const NamedReal& real : reals) {
    if (!is_finite(real)) {
      json.member(real.name, std::string_view(shortest(real.value)));
    }
  }
  json.end_object();
}

}  // namespace meshalyzer
