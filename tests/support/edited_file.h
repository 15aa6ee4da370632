#pragma once

#include "meshalyzer/io/convert/rewrite_as.h"
#include "meshalyzer/io/plain_content.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/rewrite.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// A file under edits: elements of its mesh are changed one by one, as a repair does, and the file
/// is written again.
class EditedFile {
 public:
  /// @param name  A file name; its ending decides the format where the content does not.
  EditedFile(const std::string& bytes, const std::string& name)
      : bytes_(PlainContent(bytes, name).bytes()),
        source_(parse_mesh(bytes_, name)),
        soup_(source_),
        has_vertex_normals_(has_vertex_normals(source_)),
        mesh_{source_, soup_, {}, {}} {
    // No file has the lines of records that change.
    soup_.vertex_lines.clear();
    soup_.face_lines.clear();
    for (Index v = 0; v < soup_.n_vertices(); ++v) {
      mesh_.vertices.push_back({ElementOrigin::Relation::Same, v});
    }
    for (Index f = 0; f < soup_.n_faces(); ++f) {
      mesh_.faces.push_back({ElementOrigin::Relation::Same, f});
    }
  }

  [[nodiscard]] Soup& soup() { return soup_; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

  void add_vertex(const Vec3& position, ElementOrigin origin = {}) {
    soup_.positions.push_back(position);
    if (has_vertex_normals_) soup_.normals.emplace_back(0, 0, 1);
    add_id(soup_.vertex_ids);
    mesh_.vertices.push_back(origin);
  }
  void add_face(const Triangle& corners, ElementOrigin origin) {
    soup_.triangles.push_back(corners);
    if (!soup_.corner_normals.empty()) {
      soup_.corner_normals.push_back({kNoIndex, kNoIndex, kNoIndex});
    }
    add_id(soup_.face_ids);
    mesh_.faces.push_back(origin);
  }
  void drop_face(Index face) {
    erase(soup_.triangles, face);
    erase(soup_.corner_normals, face);
    erase(soup_.face_ids.named, face);
    for (Group& group : soup_.groups) group.first_face -= group.first_face > face ? 1 : 0;
    erase(mesh_.faces, face);
  }
  /// Drops a vertex that no face names.
  void drop_vertex(Index vertex) {
    erase(soup_.positions, vertex);
    if (has_vertex_normals_) erase(soup_.normals, vertex);
    erase(soup_.vertex_ids.named, vertex);
    erase(mesh_.vertices, vertex);
    for (Triangle& t : soup_.triangles) {
      for (Index& v : t) v -= v > vertex ? 1 : 0;
    }
  }
  void drop_unused_vertices() {
    std::vector<Index> n_uses(soup_.n_vertices(), 0);
    for (const Triangle& t : soup_.triangles) {
      for (const Index v : t) ++n_uses[v];
    }
    std::vector<Index> new_index;
    Index n_used = 0;
    for (const Index n : n_uses) new_index.push_back(n > 0 ? n_used++ : kNoIndex);
    keep(soup_.positions, new_index);
    if (has_vertex_normals_) keep(soup_.normals, new_index);
    keep(soup_.vertex_ids.named, new_index);
    keep(mesh_.vertices, new_index);
    for (Triangle& t : soup_.triangles) {
      for (Index& v : t) v = new_index[v];
    }
  }

  [[nodiscard]] std::optional<RewrittenFile> rewritten() {
    if (has_vertex_normals_) soup_.corner_normals = soup_.triangles;
    return rewrite_mesh(mesh_, bytes_);
  }
  [[nodiscard]] RewrittenFile rewritten_as(Format format, Encoding encoding = Encoding::Text) {
    if (has_vertex_normals_) soup_.corner_normals = soup_.triangles;
    return rewrite_as(mesh_, bytes_, format, encoding);
  }
  [[nodiscard]] std::string rewritten_bytes() { return rewritten().value().bytes; }
  /// Returns the mesh of the file after the edits. It is read by a name with the ending of its
  /// format: its own name can have that of another one, and an edit can drop the record by which
  /// the content was known nevertheless.
  [[nodiscard]] Soup read_back() {
    return parse_mesh(rewritten_bytes(), "edited." + std::string(format_name(source_.format)));
  }

 private:
  template <typename T>
  static void erase(std::vector<T>& list, Index i) {
    if (!list.empty()) list.erase(list.begin() + i);
  }
  /// Keeps the entries of a list that have a new index; a list that is not used is empty.
  template <typename T>
  static void keep(std::vector<T>& list, const std::vector<Index>& new_index) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (new_index[i] != kNoIndex) list[new_index[i]] = std::move(list[i]);
    }
    const auto n_kept =
        std::count_if(new_index.begin(), new_index.end(), [](Index i) { return i != kNoIndex; });
    if (!list.empty()) list.resize(static_cast<std::size_t>(n_kept));
  }
  /// The place where the records are named.
  static void add_id(Ids& ids) {
    if (!ids.named.empty()) {
      ids.named.push_back(1 + *std::max_element(ids.named.begin(), ids.named.end()));
    }
  }

  std::string bytes_;
  Soup source_;
  Soup soup_;
  bool has_vertex_normals_;
  EditedMesh mesh_;
};

inline ElementOrigin made_of(Index record) {
  return {ElementOrigin::Relation::MadeOf, record};
}
inline ElementOrigin beside(Index record) {
  return {ElementOrigin::Relation::Beside, record};
}

/// Returns a text in which one part is replaced.
inline std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  return at == std::string::npos ? "nothing to replace" : text.replace(at, old.size(), now);
}

}  // namespace meshalyzer
