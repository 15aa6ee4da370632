#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The bytes of a file after edits.
struct RewrittenFile {
  std::string bytes;
  /// By face of the edited mesh: which face of the file it is; empty where they are the same.
  std::vector<Index> file_faces;
  /// What of the source is not in it, though no edit dropped it.
  std::vector<AttributeCount> lost;
};

}  // namespace meshalyzer
