#pragma once

#include "meshalyzer/report/journal/line.h"

#include <array>
#include <string_view>

namespace meshalyzer {

inline constexpr std::array kLineKinds{LineHead::Kind::Mesh, LineHead::Kind::Unreadable,
                                       LineHead::Kind::Between};

/// Returns "mesh", "unreadable" or "between".
[[nodiscard]] constexpr std::string_view kind_name(LineHead::Kind kind) {
  return kind == LineHead::Kind::Mesh         ? "mesh"
         : kind == LineHead::Kind::Unreadable ? "unreadable"
                                              : "between";
}

}  // namespace meshalyzer
