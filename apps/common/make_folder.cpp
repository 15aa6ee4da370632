#include "make_folder.h"

#include "meshalyzer/base/error.h"

#include <filesystem>
#include <system_error>

namespace meshalyzer {

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError(folder, {}, "cannot be made a folder: " + error.message());
}

}  // namespace meshalyzer
