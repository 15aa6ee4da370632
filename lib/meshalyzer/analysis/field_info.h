#pragma once

#include <string_view>
#include <tuple>

namespace meshalyzer {

/// What is said of a reported quantity, wherever it is said: in texts, in JSON and its schema, on
/// pages.
struct FieldInfo {
  /// In JSON; a program may rely on it.
  std::string_view key;
  /// For people; empty where no line of its own tells the quantity.
  std::string_view label = {};
  /// What the label means, unit included: a page shows it where it is pointed at, the schema as
  /// description.
  std::string_view definition = {};
};

/// Which analyses know a field.
enum class Known {
  Always,
  /// Not those that were asked for the attributes alone (-a).
  Measured,
};

/// A row of a table of fields: what is said of one, and where a Struct holds it.
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

/// What is said of a quantity that has a value for each vertex, edge or face: its statistics.
struct Quantity {
  FieldInfo info;
  /// Why there may be no value of it, in words that follow "undefined: ".
  std::string_view if_none;
  enum class Total { Omit, Show };
  /// Whether the sum of all values means something to people.
  Total total = Total::Omit;
};

/// A row of a table of quantities.
template <typename Struct, typename T>
struct QuantityRow {
  Quantity quantity;
  T Struct::*member;
};

}  // namespace meshalyzer
