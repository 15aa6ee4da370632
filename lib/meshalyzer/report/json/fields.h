#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/field_info.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Functions for the fields of a struct as members of a JSON object, by a table of FieldRow.

/// Writes the value of a field, or null if it has none.
template <typename T>
void write_value(JsonWriter& json, const T& value) {
  json.value(value);
}
template <typename T>
void write_value(JsonWriter& json, const Measure<T>& measure) {
  json.value(measure.value);
}
void write_value(JsonWriter& json, const Box3& box);

/// Reads the value that write_value() wrote as a member, but not the reason why there is none.
void read_value(const JsonNode& object, std::string_view key, bool& value);
void read_value(const JsonNode& object, std::string_view key, std::size_t& value);
void read_value(const JsonNode& object, std::string_view key, std::int64_t& value);
void read_value(const JsonNode& object, std::string_view key, double& value);
void read_value(const JsonNode& object, std::string_view key, Box3& value);
void read_value(const JsonNode& object, std::string_view key, std::optional<double>& value);
template <typename T>
void read_value(const JsonNode& object, std::string_view key, std::optional<T>& value) {
  value.reset();
  if (!object.member(key).is_null()) {
    read_value(object, key, value.emplace());
  }
}
template <typename T>
void read_value(const JsonNode& object, std::string_view key, Measure<T>& measure) {
  read_value(object, key, measure.value);
}

/// Returns the type of the values of a field in the schema, see schema_type.
std::string type_of(const bool& value, Known known);
std::string type_of(const std::size_t& value, Known known);
std::string type_of(const std::int64_t& value, Known known);
std::string type_of(const double& value, Known known);
std::string type_of(const Box3& value, Known known);
/// A field that may have no value is null like one that is not always known.
template <typename T>
std::string type_of(const std::optional<T>& /*value*/, Known /*known*/) {
  return type_of(T(), Known::Measured);
}
template <typename T>
std::string type_of(const Measure<T>& measure, Known known) {
  return type_of(measure.value, known);
}

/// Returns the definition of a field, and when it is null.
[[nodiscard]] std::string description_of(const FieldInfo& info, Known known);

/// Returns the real of a field that may be infinite; 0 for all others.
template <typename T>
double real_of(const T& /*value*/) {
  return 0.0;
}
inline double real_of(double value) {
  return value;
}
inline double real_of(const std::optional<double>& value) {
  return value.value_or(0.0);
}
inline double real_of(const Measure<double>& measure) {
  return measure.value.value_or(0.0);
}

/// Writes a member for each row.
/// @param known  The fields that are known; other members are null, so that all reports have the
///               same members.
template <typename Struct, typename Rows>
void write_fields(JsonWriter& json, const Struct& of, const Rows& rows, Known known) {
  for_each_row(rows, [&](const auto& row) {
    json.key(row.info.key);
    if (row.known > known) {
      json.null();
    } else {
      write_value(json, of.*row.member);
    }
  });
}

/// Writes the names of the nulls of write_fields() that stand for an infinity or NaN, if there are
/// any.
template <typename Struct, typename Rows>
void write_non_finite_fields(JsonWriter& json, const Struct& of, const Rows& rows, Known known) {
  std::vector<NamedReal> reals;
  for_each_row(rows, [&](const auto& row) {
    if (row.known <= known) {
      reals.push_back({row.info.key, real_of(of.*row.member)});
    }
  });
  std::sort(reals.begin(), reals.end(),
            [](const NamedReal& a, const NamedReal& b) { return a.name < b.name; });
  write_non_finite(json, reals);
}

/// Reads the members that write_fields() wrote.
template <typename Struct, typename Rows>
void read_fields(const JsonNode& object, Struct& of, const Rows& rows, Known known) {
  for_each_row(rows, [&](const auto& row) {
    if (row.known <= known) {
      read_value(object, row.info.key, of.*row.member);
    }
  });
}

/// Appends the schema of the members that write_fields() writes.
template <typename Struct, typename Rows>
void append_members(std::vector<SchemaMember>& members, const Struct& of, const Rows& rows) {
  for_each_row(rows, [&](const auto& row) {
    members.push_back({.key = std::string(row.info.key),
                       .description = description_of(row.info, row.known),
                       .type = type_of(of.*row.member, row.known)});
  });
}

}  // namespace meshalyzer
