#pragma once

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/types.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Appends a line `HEAD X Y Z`, each coordinate as the shortest text that reads back the same.
inline void print_record(std::string& text, std::string_view head, const Vec3& vector) {
  text += head;
  for (const double coordinate : vector) {
    text += ' ';
    append_shortest(text, coordinate);
  }
  text += '\n';
}

}  // namespace meshalyzer
