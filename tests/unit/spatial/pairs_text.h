#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"

#include <string>
#include <vector>

namespace meshalyzer {

using Pairs = std::vector<IntersectingPair>;

/// Returns intersecting pairs as lines: "0-1 crossing".
[[nodiscard]] inline std::string listed(const Pairs& pairs) {
  std::string text;
  for (const IntersectingPair& pair : pairs) {
    text += std::to_string(pair.face_a) + "-" + std::to_string(pair.face_b) + " " +
            std::string(contact_name(pair.kind)) + "\n";
  }
  return text;
}

}  // namespace meshalyzer
