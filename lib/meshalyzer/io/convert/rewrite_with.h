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
  /// Binary only where the format is PLY or STL.
  Encoding encoding = Encoding::Text;
};

/// Writes an edited mesh with attributes that its source has, as far as the format holds them.
///
/// @param said  How many attributes the files of the source say: what is not written is lost.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] RewrittenFile rewrite_with(const EditedMesh& mesh, MeshAttributes attributes,
                                         std::vector<AttributeCount> said, const FileKind& kind);

}  // namespace meshalyzer
