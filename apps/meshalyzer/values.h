#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/picture/field.h"
#include "meshalyzer/set/shard.h"

#include <cstdint>
#include <string>

namespace meshalyzer {

// The parsers for the values of options. All throw UsageError if the text is no valid value.

/// Parses "AR,ANGLE,LEN".
[[nodiscard]] GoodnessThresholds to_thresholds(const std::string& text, const std::string& option);
[[nodiscard]] VertexArea to_area(const std::string& text, const std::string& option);
[[nodiscard]] FieldName to_field(const std::string& text, const std::string& option);
[[nodiscard]] Palette to_palette(const std::string& text, const std::string& option);
/// Parses an angle in degrees, 0 to 90.
[[nodiscard]] double to_cone(const std::string& text, const std::string& option);
/// Parses "K/N", with K from 1 to N.
[[nodiscard]] Shard to_shard(const std::string& text, const std::string& option);
[[nodiscard]] std::uint64_t to_bytes(const std::string& text, const std::string& option);

}  // namespace meshalyzer
