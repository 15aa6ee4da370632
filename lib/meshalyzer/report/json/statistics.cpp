#include "meshalyzer/report/json/statistics.h"

#include "meshalyzer/report/figures.h"
#include "meshalyzer/report/json/non_finite.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The key of the first measure. Either all measures are there or none, and either all are null or
/// none.
constexpr std::string_view kFirstMeasure = kElementMeasures<Statistics>.front().quantity.info.key;

void write_figures(JsonWriter& json, const Summary& summary) {
  json.member("count", summary.count);
  json.member("infinite", summary.infinite);
  std::array<NamedReal, kFigures.size()> reals;
  std::transform(kFigures.begin(), kFigures.end(), reals.begin(), [&](const auto& figure) {
    return NamedReal{figure.info.key, summary.*figure.member};
  });
  for (const NamedReal& real : reals) {
    json.member(real.name, summary.count == 0 ? std::nullopt : std::optional(real.value));
  }
  write_non_finite(json, reals);
}

std::vector<SchemaMember> figure_members() {
  std::vector<SchemaMember> members{
      {"count", "finite values: the figures are of these alone", schema_type::kCount},
      {"infinite", "infinite values, counted apart", schema_type::kCount}};
  for (const auto& [info, member, known] : kFigures) {
    members.push_back({.key = std::string(info.key),
                       .description = std::string(info.definition),
                       .type = schema_type::kReal});
  }
  members.push_back(non_finite_member());
  return members;
}

void write_histogram(JsonWriter& json, const Histogram& histogram) {
  json.begin_object();
  json.key("edges");
  json.array(histogram.edges);
  json.key("counts");
  json.array(histogram.counts);
  json.end_object();
}

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

Statistics read_statistics(const JsonNode& object) {
  Statistics statistics{read_summary(object), {}};
  if (statistics.count != 0) {
    statistics.histogram = read_histogram(object.member("histogram"));
  }
  return statistics;
}

void write_summary(JsonWriter& json, const Summary& summary) {
  json.begin_object(JsonLayout::Row);
  write_figures(json, summary);
  json.end_object();
}

Summary read_summary(const JsonNode& object) {
  Summary summary;
  summary.count = object.member("count").count();
  summary.infinite = object.member("infinite").count();
  if (summary.count != 0) {
    for (const auto& [info, member, known] : kFigures) {
      summary.*member = read_real(object, info.key);
    }
  }
  return summary;
}

void write_measures(JsonWriter& json, const ElementMeasures<Statistics>* measures) {
  for (const auto& [quantity, member] : kElementMeasures<Statistics>) {
    json.key(quantity.info.key);
    if (measures == nullptr) {
      json.null();
    } else {
      write_statistics(json, measures->*member);
    }
  }
}

void write_measures(JsonWriter& json, const ElementMeasures<Summary>& measures) {
  for (const auto& [quantity, member] : kElementMeasures<Summary>) {
    json.key(quantity.info.key);
    write_summary(json, measures.*member);
  }
}

bool has_measures(const JsonNode& object) {
  return object.find(kFirstMeasure).has_value();
}

bool has_null_measures(const JsonNode& object) {
  return object.member(kFirstMeasure).is_null();
}

void read_measures(const JsonNode& object, ElementMeasures<Statistics>& measures) {
  for (const auto& [quantity, member] : kElementMeasures<Statistics>) {
    measures.*member = read_statistics(object.member(quantity.info.key));
  }
}

void read_measures(const JsonNode& object, ElementMeasures<Summary>& measures) {
  for (const auto& [quantity, member] : kElementMeasures<Summary>) {
    measures.*member = read_summary(object.member(quantity.info.key));
  }
}

void define_statistics(SchemaDefinitions& schema) {
  SchemaObject summary{.description = "statistics without histogram", .members = figure_members()};
  schema.define("summary", summary);
  SchemaObject statistics{
      .description =
          "null where only the attributes were asked for; every figure is null where count is 0",
      .members = std::move(summary.members),
      .null = SchemaObject::Null::Sometimes};
  statistics.members.push_back(
      {"histogram", "null where count is 0", schema_reference("histogram")});
  schema.define("statistics", statistics);
  const std::string bins = std::to_string(Histogram::kBins);
  const std::string edges = std::to_string(Histogram::kBins + 1);
  schema.define(
      "histogram",
      {.description = "bins of equal width, from the smallest to the largest value",
       .members = {{"edges", "",
                    R"("type": "array", "items": {"type": "number"}, "minItems": )" + edges +
                        R"(, "maxItems": )" + edges},
                   {"counts", "",
                    R"("type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": )" +
                        bins + R"(, "maxItems": )" + bins}},
       .null = SchemaObject::Null::Sometimes});
}

SchemaMember statistics_member(const Quantity& quantity) {
  return {.key = std::string(quantity.info.key),
          .description = std::string(quantity.info.definition),
          .type = schema_reference("statistics")};
}

void append_measures(std::vector<SchemaMember>& members, std::string_view type,
                     SchemaMember::Presence presence) {
  for (const auto& [quantity, member] : kElementMeasures<Statistics>) {
    SchemaMember& row = members.emplace_back(statistics_member(quantity));
    row.type = schema_reference(type);
    row.presence = presence;
  }
}

}  // namespace meshalyzer
