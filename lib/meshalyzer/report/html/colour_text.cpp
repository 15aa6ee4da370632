#include "meshalyzer/report/html/colour_text.h"

#include <fmt/format.h>

namespace meshalyzer {

std::string colour_text(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

}  // namespace meshalyzer
