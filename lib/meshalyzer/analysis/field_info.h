#pragma once

#include <string_view>
#include <tuple>

namespace meshalyzer {

/// Describes a reported quantity for all outputs: texts, JSON and its schema, pages.
struct FieldInfo {
  /// The key in JSON. Programs rely on it, so that it never changes.
  std::string_view key;
  /// The label for people; empty if the quantity has no line of its own.
  std::string_view label = {};
  /// Explains the label and names the unit: pages show it as a tooltip, the schema as the
  /// description.
  std::string_view definition = {};
};

/// The analyses that fill in a field.
enum class Known {
  Always,
  /// All analyses except those with Scope::AttributesOnly.
  Measured,
};

/// A row of a table of fields: the description of a field, and its member in a Struct.
template <typename Struct, typename T>
struct FieldRow {
  FieldInfo info;
  T Struct::*member;
  Known known = Known::Always;
};
template <typename Struct, typename T>
FieldRow(FieldInfo, T Struct::*) -> FieldRow<Struct, T>;
template <typename Struct, typename T>
FieldRow(FieldInfo, T Struct::*, Known) -> FieldRow<Struct, T>;

/// Calls `visit` with each row of a table whose fields are of several types, a tuple.
template <typename Rows, typename Visit>
constexpr void for_each_row(const Rows& rows, const Visit& visit) {
  std::apply([&](const auto&... row) { (visit(row), ...); }, rows);
}

/// Describes a quantity that has a value for each vertex, edge or face, and the statistics of these
/// values.
struct Quantity {
  FieldInfo info;
  /// The reason why there may be no value, in words that follow "undefined: "; empty if there
  /// always is one.
  std::string_view if_none;
  enum class Total { Omit, Show };
  /// Tells whether the sum of all values is reported.
  Total total = Total::Omit;
};

/// A row of a table of quantities.
template <typename Struct, typename T>
struct QuantityRow {
  Quantity quantity;
  T Struct::*member;
};

}  // namespace meshalyzer
