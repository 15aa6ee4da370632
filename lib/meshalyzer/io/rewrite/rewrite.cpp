#include "meshalyzer/io/rewrite/rewrite.h"

#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/rewrite/rewriters.h"

#include <utility>

namespace meshalyzer {
namespace {

std::optional<RewrittenFile> rewrite_by_format(const EditedMesh& mesh, std::string_view bytes) {
  switch (mesh.source.format) {
    case Format::Mesh:
      return rewrite_mesh_format(mesh, bytes);
    case Format::Obj:
      return rewrite_obj(mesh, bytes);
    case Format::Off:
      return is_binary(bytes, Format::Off) ? std::nullopt : std::optional(rewrite_off(mesh, bytes));
    case Format::Stl:
      return is_binary(bytes, Format::Stl) ? rewrite_binary_stl(mesh, bytes)
                                           : rewrite_ascii_stl(mesh, bytes);
    case Format::Ply:
      return rewrite_ply(mesh, bytes);
    case Format::Inria:
      return rewrite_inria(mesh, bytes);
  }
  return std::nullopt;
}

}  // namespace

std::optional<RewrittenFile> rewrite_mesh(const EditedMesh& mesh, std::string_view bytes) {
  std::optional<RewrittenFile> file = rewrite_by_format(mesh, bytes);
  if (file) {
    for (const LostRecord& record : file->lost_records) {
      file->lost.push_back({record.kind, 1});
    }
    file->lost = summed(std::move(file->lost));
  }
  return file;
}

}  // namespace meshalyzer
