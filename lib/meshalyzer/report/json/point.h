#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

/// Writes a point as a row of its three coordinates.
void write_point(JsonWriter& json, const Vec3& point);

/// Reads a point that write_point() wrote.
/// @throws InvalidArgument  if it is not three reals.
[[nodiscard]] Vec3 read_point(const JsonNode& node);

/// Defines "point", which write_point() writes, and "box", of two of them.
void define_points(SchemaDefinitions& schema);

}  // namespace meshalyzer
