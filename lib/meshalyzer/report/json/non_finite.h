#pragma once

#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

namespace meshalyzer {

/// A real that is a member of a JSON object.
struct NamedReal {
  std::string_view name;
  double value = 0.0;
};

/// Writes a further member "non_finite" if any of the reals is infinite or NaN; it has the value of
/// each such null, "inf", "-inf", "nan" or "-nan".
void write_non_finite(JsonWriter& json, std::span<const NamedReal> reals);
inline void write_non_finite(JsonWriter& json, std::initializer_list<NamedReal> reals) {
  write_non_finite(json, std::span(reals.begin(), reals.end()));
}

/// Returns a real that is a member of `object`, from the member of write_non_finite() if it is
/// null.
/// @return Nothing if it is null and not there either.
[[nodiscard]] std::optional<double> find_real(const JsonNode& object, std::string_view name);

/// Returns a real that must have a value.
[[nodiscard]] double read_real(const JsonNode& object, std::string_view name);

/// Defines "non_finite", which write_non_finite() writes.
void define_non_finite(SchemaDefinitions& schema);

/// Returns the schema of this member.
[[nodiscard]] SchemaMember non_finite_member();

}  // namespace meshalyzer
