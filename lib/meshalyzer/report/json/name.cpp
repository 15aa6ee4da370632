#include "meshalyzer/report/json/name.h"

#include "meshalyzer/report/utf8.h"

#include <algorithm>

namespace meshalyzer {
namespace {

void append_byte(std::string& text, char byte) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  const auto code = static_cast<unsigned char>(byte);
  text += kReplacementCharacter;
  text += kHex[code / 16U];
  text += kHex[code % 16U];
}

}  // namespace

std::string json_name(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t length = utf8_sequence_length(name, i);
    const std::string_view character = name.substr(i, std::max<std::size_t>(1, length));
    if (length == 0 || character == kReplacementCharacter) {
      std::for_each(character.begin(), character.end(),
                    [&](char byte) { append_byte(text, byte); });
    } else {
      text += character;
    }
    i += character.size();
  }
  return text;
}

}  // namespace meshalyzer
