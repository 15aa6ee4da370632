#include "meshalyzer/report/json/statistics_reader.h"

#include "meshalyzer/base/numbers.h"

#include <cmath>

namespace meshalyzer {
namespace {

Histogram read_histogram(const JsonNode& object) {
  Histogram histogram;
  JsonElements edges = object.member("edges").elements();
  for (double& edge : histogram.edges) {
    edge = edges.next().real();
  }
  edges.expect_end();
  JsonElements counts = object.member("counts").elements();
  for (std::size_t& count : histogram.counts) {
    count = counts.next().count();
  }
  counts.expect_end();
  return histogram;
}

double read_non_finite(const JsonNode& node) {
  const std::optional<double> value = parse_real(node.text());
  if (!value || std::isfinite(*value)) {
    node.refuse("neither infinite nor NaN");
  }
  return *value;
}

}  // namespace

std::optional<double> find_real(const JsonNode& object, std::string_view name) {
  if (const JsonNode node = object.member(name); !node.is_null()) {
    return node.real();
  }
  if (const std::optional<JsonNode> others = object.find("non_finite")) {
    if (const std::optional<JsonNode> node = others->find(name)) {
      return read_non_finite(*node);
    }
  }
  return std::nullopt;
}

double read_real(const JsonNode& object, std::string_view name) {
  const std::optional<double> value = find_real(object, name);
  if (!value) {
    object.member(name).refuse("no value");
  }
  return *value;
}

Summary read_summary(const JsonNode& object) {
  Summary summary;
  summary.count = object.member("count").count();
  summary.infinite = object.member("infinite").count();
  if (summary.count != 0) {
    summary.min = read_real(object, "min");
    summary.max = read_real(object, "max");
    summary.mean = read_real(object, "mean");
    summary.median = read_real(object, "median");
    summary.variance = read_real(object, "variance");
    summary.total = read_real(object, "total");
  }
  return summary;
}

Statistics read_statistics(const JsonNode& object) {
  Statistics statistics{read_summary(object), {}};
  if (statistics.count != 0) {
    statistics.histogram = read_histogram(object.member("histogram"));
  }
  return statistics;
}

}  // namespace meshalyzer
