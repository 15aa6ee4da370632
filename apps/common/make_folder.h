#pragma once

#include <string>

namespace meshalyzer {

/// Makes a folder, and all its parents, unless they exist.
/// @throws IoError  if that fails.
void make_folder(const std::string& folder);

}  // namespace meshalyzer
