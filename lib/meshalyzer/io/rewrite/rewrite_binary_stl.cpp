#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/rewriters.h"
#include "meshalyzer/io/stl.h"
#include "meshalyzer/io/stl_layout.h"

#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// Tells whether a face equals a facet of the source to the bit.
bool is_untouched(const EditedMesh& mesh, Index face) {
  const ElementOrigin& origin = mesh.faces[face];
  return origin.relation == ElementOrigin::Relation::Same &&
         corners_of(mesh.soup, face) == corners_of(mesh.source, origin.record);
}

std::string_view facet(std::string_view content, Index record) {
  return content.substr(kStlFacetsOffset + kStlFacetBytes * record, kStlFacetBytes);
}

void append_facet(std::string& bytes, const EditedMesh& mesh, Index face,
                  std::string_view content) {
  const auto append = [&](const Vec3& vector) {
    for (const double number : vector) {
      append_little_endian(bytes, static_cast<float>(number));
    }
  };
  append(unit_normal(mesh.soup, mesh.soup.triangles[face]));
  for (const Vec3& corner : corners_of(mesh.soup, face)) {
    append(corner);
  }
  const ElementOrigin& origin = mesh.faces[face];
  if (origin.relation == ElementOrigin::Relation::Beside) {
    append_little_endian(bytes, std::uint16_t{0});
  } else {
    bytes += facet(content, origin.record).substr(kStlAttributeOffset);
  }
}

}  // namespace

std::optional<RewrittenFile> rewrite_binary_stl(const EditedMesh& mesh, std::string_view content) {
  require_all_vertices(mesh.soup);
  if (!fits_floats(mesh.soup)) return std::nullopt;
  RewrittenFile file;
  file.bytes = content.substr(0, kStlHeaderBytes);
  file.bytes.reserve(kStlFacetsOffset + kStlFacetBytes * mesh.soup.n_faces());
  append_little_endian(file.bytes, static_cast<std::uint32_t>(mesh.soup.n_faces()));
  for (std::size_t f = 0; f < mesh.soup.n_faces(); ++f) {
    const auto face = static_cast<Index>(f);
    if (is_untouched(mesh, face)) {
      file.bytes += facet(content, mesh.faces[face].record);
    } else {
      append_facet(file.bytes, mesh, face, content);
    }
  }
  return file;
}

}  // namespace meshalyzer
