#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/picture/field.h"
#include "meshalyzer/set/shard.h"

#include <cstdint>
#include <string>

namespace meshalyzer {

// What the values of options are read with. All throw UsageError where the text is none.

/// "AR,ANGLE,LEN".
[[nodiscard]] GoodnessThresholds to_thresholds(const std::string& text, const std::string& option);
[[nodiscard]] VertexArea to_area(const std::string& text, const std::string& option);
[[nodiscard]] FieldName to_field(const std::string& text, const std::string& option);
[[nodiscard]] Palette to_palette(const std::string& text, const std::string& option);
/// Degrees, 0 to 90.
[[nodiscard]] double to_cone(const std::string& text, const std::string& option);
/// "K/N", K from 1.
[[nodiscard]] Shard to_shard(const std::string& text, const std::string& option);
[[nodiscard]] std::uint64_t to_bytes(const std::string& text, const std::string& option);

}  // namespace meshalyzer
