#include "meshalyzer/io/convert/rewrite_together.h"

#include "meshalyzer/io/convert/count_attributes.h"
#include "meshalyzer/io/convert/read_attributes.h"
#include "meshalyzer/io/convert/rewrite_with.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

/// Concatenates the attributes of several meshes.
class JoinedAttributes {
 public:
  void add(const Soup& soup, MeshAttributes more) {
    const std::size_t n_records = n_records_ + more.faces.size();
    const std::size_t n_faces = n_faces_ + soup.n_faces();
    const std::size_t n_vertices = n_vertices_ + soup.n_vertices();
    append(std::move(more.vertex_colours), n_vertices_, n_vertices, all_.vertex_colours);
    append(std::move(more.face_colours), n_records_, n_records, all_.face_colours);
    append(std::move(more.texture), n_faces_ + 2 * n_records_, n_faces + 2 * n_records,
           all_.texture);
    append(std::move(more.vertex_references), n_vertices_, n_vertices, all_.vertex_references);
    append(std::move(more.face_references), n_records_, n_records, all_.face_references);
    append(std::move(more.attribute_words), n_faces_, n_faces, all_.attribute_words);
    all_.n_texture_points += more.n_texture_points;
    for (std::size_t r = 1; r <= more.faces.size(); ++r) {
      all_.faces.first_triangle.push_back(
          static_cast<Index>(n_faces_ + more.faces.first_triangle[r]));
    }
    add_groups(more.solids.empty() ? soup.groups : more.solids);
    all_.comments.insert(all_.comments.end(), more.comments.begin(), more.comments.end());
    n_records_ = n_records;
    n_faces_ = n_faces;
    n_vertices_ = n_vertices;
  }

  [[nodiscard]] MeshAttributes take() { return std::move(all_); }

 private:
  /// @param before  The number of elements of the meshes before.
  /// @param behind  That number including the elements of this mesh.
  template <typename T>
  static void append(std::vector<T> more, std::size_t before, std::size_t behind,
                     std::vector<T>& all) {
    if (more.empty() && all.empty()) return;
    all.resize(before);
    all.insert(all.end(), more.begin(), more.end());
    all.resize(behind);
  }

  /// Appends groups; faces without a group after some that have one get one without a name.
  void add_groups(const std::vector<Group>& groups) {
    const auto first = static_cast<Index>(n_faces_);
    const bool begins_without = groups.empty() || groups.front().first_face != 0;
    if (begins_without && !all_.solids.empty()) all_.solids.push_back({"", first});
    for (const Group& group : groups) {
      all_.solids.push_back({group.name, group.first_face + first});
    }
  }

  MeshAttributes all_;
  std::size_t n_records_ = 0;
  std::size_t n_faces_ = 0;
  std::size_t n_vertices_ = 0;
};

}  // namespace

RewrittenFile rewrite_together(const EditedMesh& mesh, std::span<const ReadFile> files,
                               Format format, Encoding encoding) {
  JoinedAttributes joined;
  std::vector<AttributeCount> counts;
  for (const ReadFile& file : files) {
    joined.add(file.soup, read_attributes(file.soup, file.bytes));
    for (const AttributeCount& count : count_attributes(file.soup, file.bytes)) {
      counts.push_back(count);
    }
  }
  return rewrite_with(mesh, joined.take(), summed(std::move(counts)), {format, encoding});
}

}  // namespace meshalyzer
