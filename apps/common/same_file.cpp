#include "same_file.h"

#include <filesystem>
#include <system_error>

namespace meshalyzer {

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error) && !error) return true;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(a, error);
  return !error && whole == std::filesystem::weakly_canonical(b, error) && !error;
}

}  // namespace meshalyzer
