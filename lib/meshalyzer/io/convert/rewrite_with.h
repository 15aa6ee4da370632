#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/io/convert/mesh_attributes.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/io/rewrite/rewritten_file.h"
#include "meshalyzer/io/write.h"

#include <vector>

namespace meshalyzer {

/// The kind of a file that is written.
struct FileKind {
  Format format = Format::Mesh;
  /// The encoding; binary only for PLY and STL.
  Encoding encoding = Encoding::Text;
};

/// Writes an edited mesh with the attributes of its source that the format can hold.
///
/// @param counts  The numbers of attributes in the files of the source; those that are not written
///                are lost.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] RewrittenFile rewrite_with(const EditedMesh& mesh, MeshAttributes attributes,
                                         std::vector<AttributeCount> counts, const FileKind& kind);

}  // namespace meshalyzer
