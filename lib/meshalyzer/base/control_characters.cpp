#include "meshalyzer/base/control_characters.h"

namespace meshalyzer {

std::string without_controls(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20U || code == 0x7FU) c = '?';
  }
  return line;
}

}  // namespace meshalyzer
