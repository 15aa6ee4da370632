#include "meshalyzer/report/format_text.h"

#include "meshalyzer/io/format_of.h"

#include <fmt/format.h>

namespace meshalyzer {

std::string_view misleading_format(std::string_view path, Format format) {
  return is_named_as(path, format) ? "" : format_name(*format_of_name(path));
}

std::string format_text(std::string_view path, Format format) {
  const std::string_view name = format_name(format);
  const std::string_view misleading = misleading_format(path, format);
  return misleading.empty()
             ? std::string(name)
             : fmt::format("{} (by its content; its name says {})", name, misleading);
}

std::string file_text(std::string_view path, Format format) {
  const std::string_view misleading = misleading_format(path, format);
  return fmt::format("{} file{}{}", format_name(format), misleading.empty() ? "" : " called ",
                     misleading);
}

}  // namespace meshalyzer
