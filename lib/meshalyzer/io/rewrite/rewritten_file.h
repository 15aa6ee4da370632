#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A record of the source that was dropped with an element that it names or follows.
struct LostRecord {
  AttributeKind kind = AttributeKind::Comments;
  /// Its offset in the source, or in the converted source.
  std::size_t offset = 0;
};

/// The bytes of a file after edits.
struct RewrittenFile {
  std::string bytes;
  /// The face of the file that each face of the edited mesh is; empty if they are the same.
  std::vector<Index> file_faces;
  /// The losses: parts of the source that are missing although no edit dropped them.
  std::vector<AttributeCount> lost;
  /// The losses that are records whose elements were dropped. If a mesh is written in parts,
  /// another part may have them.
  std::vector<LostRecord> lost_records;
};

}  // namespace meshalyzer
