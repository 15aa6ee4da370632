#include "meshalyzer/io/convert/rewrite_as.h"

#include "meshalyzer/io/convert/count_attributes.h"
#include "meshalyzer/io/convert/print_attributes.h"
#include "meshalyzer/io/convert/read_attributes.h"
#include "meshalyzer/io/convert/rewrite_with.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/rewrite.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

bool holds_polygons(Format format) {
  return format == Format::Obj || format == Format::Off || format == Format::Ply;
}

std::size_t count_colours(const std::vector<std::optional<Rgba>>& colours) {
  return static_cast<std::size_t>(
      std::count_if(colours.begin(), colours.end(), [](const auto& colour) { return !!colour; }));
}

std::size_t count_set(const std::vector<std::int32_t>& references) {
  return references.size() -
         static_cast<std::size_t>(std::count(references.begin(), references.end(), 0));
}

/// Drops the attributes that a format cannot hold.
void drop_what_is_not_held(MeshAttributes& attributes, const Soup& soup, Format format) {
  if (!holds_polygons(format)) {
    attributes.faces = single_triangles(soup.n_faces());
    attributes.vertex_colours.clear();
  }
  if (format != Format::Off && format != Format::Ply) {
    attributes.face_colours.clear();
  }
  const bool holds_texture =
      format == Format::Obj || format == Format::Ply ||
      (format == Format::Off && !texture_of_vertices(attributes, soup).empty());
  if (!holds_texture) {
    attributes.texture.clear();
    attributes.n_texture_points = 0;
  }
  if (format != Format::Ply) {
    attributes.attribute_words.clear();
    attributes.vertex_references.clear();
    attributes.face_references.clear();
  }
  if (format != Format::Obj) {
    attributes.solids.clear();
  }
  if (format == Format::Stl) {
    attributes.comments.clear();
  }
}

/// Returns how many attributes of a kind are held, of the number that there are.
std::size_t n_held(const AttributeCount& count, const MeshAttributes& attributes,
                   const Soup& printed, Format format) {
  switch (count.kind) {
    case AttributeKind::Polygons:
      return holds_polygons(format) ? count.count : 0;
    case AttributeKind::VertexColours:
      return count_colours(attributes.vertex_colours);
    case AttributeKind::FaceColours:
      return count_colours(attributes.face_colours);
    case AttributeKind::TextureCoordinates:
      return attributes.n_texture_points;
    case AttributeKind::References:
      return count_set(attributes.vertex_references) + count_set(attributes.face_references);
    case AttributeKind::AttributeWords:
      return attributes.attribute_words.empty() ? 0 : count.count;
    case AttributeKind::Headers:
    case AttributeKind::Comments:
      return attributes.comments.size();
    case AttributeKind::Groups:
      return attributes.solids.empty() && !(format == Format::Obj && printed.format == Format::Obj)
                 ? 0
                 : count.count;
    case AttributeKind::Normals:
      return format == Format::Obj || ((format == Format::Ply || format == Format::Off) &&
                                       has_vertex_normals(printed))
                 ? count.count
                 : 0;
    default:
      return 0;
  }
}

/// Returns how many elements without a colour become white: PLY has a colour for each vertex or
/// face if any has one, and OFF for each vertex.
///
/// @param colours  The number of vertex colours or face colours in the source.
std::size_t n_absent_colours(const AttributeCount& colours, const MeshAttributes& attributes,
                             Format format) {
  const bool becomes_white =
      colours.kind == AttributeKind::VertexColours
          ? format != Format::Obj
          : colours.kind == AttributeKind::FaceColours && format == Format::Ply;
  const std::size_t n = colours.kind == AttributeKind::VertexColours
                            ? attributes.vertex_colours.size()
                            : attributes.face_colours.size();
  return becomes_white ? n - std::min(n, colours.count) : 0;
}

bool has_attributes(const MeshAttributes& attributes, const Soup& soup) {
  return attributes.faces.size() != soup.n_faces() || !attributes.vertex_colours.empty() ||
         !attributes.face_colours.empty() || !attributes.texture.empty() ||
         !attributes.vertex_references.empty() || !attributes.face_references.empty() ||
         !attributes.attribute_words.empty() || !attributes.solids.empty() ||
         !attributes.comments.empty();
}

std::string print_with(const MeshAttributes& attributes, const Soup& soup, Format format,
                       Encoding encoding) {
  switch (format) {
    case Format::Obj:
      return print_obj_with(attributes, soup);
    case Format::Off:
      return print_off_with(attributes, soup);
    case Format::Ply:
      return print_ply_with(attributes, soup, encoding);
    default:
      return print_mesh(soup, format, encoding);
  }
}

/// Writes the mesh as it was read as a file of the other format first, and edits that.
RewrittenFile rewrite_converted(const EditedMesh& mesh, const MeshAttributes& attributes,
                                Format format, Encoding encoding) {
  const std::string converted = print_with(attributes, mesh.source, format, encoding);
  const Soup source = parse_mesh(converted, "a." + std::string(format_name(format)));
  return rewrite_mesh({source, mesh.soup, mesh.vertices, mesh.faces, mesh.left_places}, converted)
      .value();
}

RewrittenFile print_plainly(const Soup& soup, const MeshAttributes& attributes, Format format,
                            Encoding encoding) {
  RewrittenFile file;
  if (format == Format::Mesh || format == Format::Inria) {
    for (const std::string& comment : attributes.comments) {
      file.bytes += '#' + comment + '\n';
    }
  }
  file.bytes += print_mesh(soup, format, encoding);
  return file;
}

}  // namespace

RewrittenFile rewrite_with(const EditedMesh& mesh, MeshAttributes attributes,
                           std::vector<AttributeCount> counts, const FileKind& kind) {
  require_all_vertices(mesh.soup);
  const Format format = kind.format;
  drop_what_is_not_held(attributes, mesh.source, format);
  std::size_t n_absent = 0;
  for (AttributeCount& count : counts) {
    n_absent += n_absent_colours(count, attributes, format);
    count.count -= std::min(count.count, n_held(count, attributes, mesh.soup, format));
  }
  counts.push_back({AttributeKind::AbsentColours, n_absent});
  if (format == Format::Obj && have_opacity(attributes.vertex_colours)) {
    counts.push_back({AttributeKind::VertexProperties, 1});
  }
  const bool is_edited = holds_polygons(format) && has_attributes(attributes, mesh.source);
  RewrittenFile file = is_edited ? rewrite_converted(mesh, attributes, format, kind.encoding)
                                 : print_plainly(mesh.soup, attributes, format, kind.encoding);
  counts.insert(counts.end(), file.lost.begin(), file.lost.end());
  file.lost = summed(std::move(counts));
  return file;
}

RewrittenFile rewrite_as(const EditedMesh& mesh, std::string_view bytes, Format format,
                         Encoding encoding) {
  return rewrite_with(mesh, read_attributes(mesh.source, bytes),
                      count_attributes(mesh.source, bytes), {format, encoding});
}

}  // namespace meshalyzer
