#pragma once

#include <cstdint>

namespace meshalyzer {

/// Tells whether faces may come to face the other side when widen_facets() moves a vertex.
enum class TurningOver : std::uint8_t { Forbidden, Permitted };

}  // namespace meshalyzer
