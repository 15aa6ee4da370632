#include "meshalyzer/base/error.h"

#include "meshalyzer/base/control_characters.h"

namespace meshalyzer {
namespace {

std::string located(const std::string& path, FilePlace place, const std::string& what) {
  const std::string file = without_controls(path);
  if (place.line != 0) {
    return file + ":" + std::to_string(place.line) + ": " + what;
  }
  if (place.byte != FilePlace::kNoByte) {
    return file + ":byte " + std::to_string(place.byte) + ": " + what;
  }
  return file + ": " + what;
}

}  // namespace

IoError::IoError(const std::string& file, FilePlace place, const std::string& what)
    : Error(located(file, place, what)), file_(file), reason_(what), place_(place) {}

}  // namespace meshalyzer
