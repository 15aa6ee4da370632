#include "meshalyzer/report/journal/for_each_line.h"

#include "meshalyzer/base/error.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

/// Tells whether the bytes after the last line feed can be the rest of a line of a killed run. A
/// file that is no journal must not be accepted, because it would be overwritten.
bool is_torn_line(std::string_view rest) {
  constexpr std::string_view kBegin = "{\"number\": ";
  const std::size_t length = std::min(rest.size(), kBegin.size());
  return rest.substr(0, length) == kBegin.substr(0, length);
}

}  // namespace

void for_each_line(std::string_view journal, const std::string& file,
                   const std::function<void(std::string_view)>& use) {
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < journal.size();) {
    const std::size_t end = journal.find('\n', begin);
    ++number;
    if (end == std::string_view::npos) {
      if (!is_torn_line(journal.substr(begin))) {
        throw IoError(file, {.line = number}, "not the beginning of a line of a journal");
      }
      return;
    }
    try {
      use(journal.substr(begin, end - begin));
    } catch (const InvalidArgument& error) {
      throw IoError(file, {.line = number}, error.what());
    }
    begin = end + 1;
  }
}

}  // namespace meshalyzer
