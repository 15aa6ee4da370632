#include "file_ending.h"

#include "usage_error.h"

#include <algorithm>
#include <filesystem>

namespace meshalyzer {

std::string require_ending(const std::string& file, std::string_view option,
                           std::initializer_list<std::string_view> endings) {
  std::string ending = std::filesystem::path(file).extension().string();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end()) {
    std::string message(option);
    message += " needs a FILE that ends in";
    std::string_view before = " ";
    for (const std::string_view known : endings) {
      message += before;
      message += known;
      before = " or ";
    }
    message += ", not '";
    message += file;
    message += '\'';
    throw UsageError(message);
  }
  return ending;
}

}  // namespace meshalyzer
