#pragma once

#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/io/rewrite/rewritten_file.h"
#include "meshalyzer/io/write.h"

#include <span>
#include <string_view>

namespace meshalyzer {

/// A file that was read.
struct ReadFile {
  const Soup& soup;
  /// The content from which the soup was parsed, not gzipped and without a byte order mark.
  std::string_view bytes;
};

/// Writes a mesh that combines those of several files as one file, with the attributes of all files
/// that its format can hold: see rewrite_as().
///
/// @param mesh   The mesh, whose source holds the records of all files, concatenated.
/// @param files  The files, at least one.
/// @throws InvalidArgument if a face has a corner without a vertex.
/// @complexity O(bytes + #F log #F).
[[nodiscard]] RewrittenFile rewrite_together(const EditedMesh& mesh,
                                             std::span<const ReadFile> files, Format format,
                                             Encoding encoding = Encoding::Text);

}  // namespace meshalyzer
