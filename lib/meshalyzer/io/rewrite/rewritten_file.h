#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A record of the source that went because an element went which it names or stands behind.
struct LostRecord {
  AttributeKind kind = AttributeKind::Comments;
  /// Where it stands in the source, or in what the source was turned into.
  std::size_t offset = 0;
};

/// The bytes of a file after edits.
struct RewrittenFile {
  std::string bytes;
  /// Tells which face of the file each face of the edited mesh is; empty where they are the same.
  std::vector<Index> file_faces;
  /// What of the source is not in it, though no edit dropped it.
  std::vector<AttributeCount> lost;
  /// Tells which of that are records whose elements went. Where a mesh is written in parts, another
  /// part may have them.
  std::vector<LostRecord> lost_records;
};

}  // namespace meshalyzer
