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
  /// What the soup was parsed from, not gzipped and without a byte order mark.
  std::string_view bytes;
};

/// Writes a mesh that was made of those of several files as one file, with what its format can say
/// of what they said, each of its own elements: see rewrite_as().
///
/// @param mesh   Its source holds the records of all files, one file behind the other.
/// @param files  At least one.
/// @throws InvalidArgument if a face has a corner without a vertex.
/// @complexity O(bytes + #F log #F).
[[nodiscard]] RewrittenFile rewrite_together(const EditedMesh& mesh,
                                             std::span<const ReadFile> files, Format format,
                                             Encoding encoding = Encoding::Text);

}  // namespace meshalyzer
