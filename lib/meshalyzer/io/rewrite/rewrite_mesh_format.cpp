#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/face_plan.h"
#include "meshalyzer/io/rewrite/rewriters.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

/// The offsets of the lines of each kind.
struct NativeRecords {
  std::vector<std::size_t> vertices;
  std::vector<std::size_t> faces;
  std::vector<std::size_t> torn;
};

NativeRecords find_records(std::string_view text) {
  NativeRecords records;
  TextScanner in(text);
  while (in.next_record()) {
    const std::size_t begin = text.size() - in.remaining();
    const std::string_view keyword = in.word();
    auto& list = keyword == "Vertex" ? records.vertices
                 : keyword == "Face" ? records.faces
                                     : records.torn;
    list.push_back(begin);
    in.skip_record();
  }
  return records;
}

class NativeRewriter {
 public:
  NativeRewriter(const EditedMesh& mesh, std::string_view text)
      : mesh_(mesh), records_(find_records(text)), edits_(text) {}

  RewrittenFile rewrite() {
    edit_vertices();
    edit_faces();
    if (mesh_.soup.torn_lines.empty()) {
      for (const std::size_t torn : records_.torn) {
        edits_.replace_lines(span_of(words(torn)), {});
      }
    }
    return {edits_.apply(), {}, {}, edits_.lost()};
  }

 private:
  [[nodiscard]] std::vector<std::string_view> words(std::size_t record) const {
    return words_at(edits_.source(), record, Continuation::None);
  }

  [[nodiscard]] std::string vertex_id(Index v) const {
    return std::to_string(mesh_.soup.vertex_ids.of(v));
  }

  void edit_vertices() {
    const std::vector<Index> numbers = new_vertices(mesh_);
    for (Index r = 0; r < numbers.size(); ++r) {
      if (numbers[r] == kNoIndex) {
        edits_.replace_lines(span_of(words(records_.vertices[r])), {});
      } else {
        edit_vertex(r, numbers[r]);
      }
    }
    std::string added;
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      if (mesh_.vertices[v].relation != ElementOrigin::Relation::Same) {
        added += "Vertex " + vertex_id(static_cast<Index>(v));
        for (const double coordinate : mesh_.soup.positions[v]) {
          added += ' ';
          append_shortest(added, coordinate);
        }
        added += edits_.line_end();
      }
    }
    insert_behind(records_.vertices, std::move(added));
  }

  void edit_vertex(Index record, Index v) {
    const Vec3& before = mesh_.source.positions[record];
    const Vec3& now = mesh_.soup.positions[v];
    const bool keeps_id = mesh_.soup.vertex_ids.of(v) == mesh_.source.vertex_ids.of(record);
    if (now == before && keeps_id) {
      return;
    }
    const std::vector<std::string_view> old = words(records_.vertices[record]);
    if (!keeps_id) {
      edits_.replace_integer(old[1], mesh_.soup.vertex_ids.of(v));
    }
    edits_.replace_numbers(std::span(old).subspan(2), {before.data(), 3}, {now.data(), 3});
  }

  void edit_faces() {
    const std::vector<Index> numbers = new_faces(mesh_);
    for (Index r = 0; r < numbers.size(); ++r) {
      if (numbers[r] == kNoIndex) {
        edits_.replace_lines(span_of(words(records_.faces[r])), {});
      } else if (!is_same(r, numbers[r])) {
        edit_face(r, numbers[r]);
      }
    }
    std::string added;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      if (mesh_.faces[f].relation != ElementOrigin::Relation::Same) {
        added += face_line(static_cast<Index>(f));
      }
    }
    insert_behind(records_.faces.empty() ? records_.vertices : records_.faces, std::move(added));
  }

  [[nodiscard]] std::string face_line(Index face) const {
    std::string line = "Face " + std::to_string(mesh_.soup.face_ids.of(face));
    for (const Index corner : mesh_.soup.triangles[face]) {
      line += ' ' + vertex_id(corner);
    }
    return line + edits_.line_end();
  }

  [[nodiscard]] bool is_same(Index record, Index face) const {
    bool is_equal = mesh_.soup.face_ids.of(face) == mesh_.source.face_ids.of(record);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index before = mesh_.source.triangles[record][k];
      is_equal = is_equal && before != kNoIndex &&
                 mesh_.soup.vertex_ids.of(mesh_.soup.triangles[face][k]) ==
                     mesh_.source.vertex_ids.of(before);
    }
    return is_equal;
  }

  void edit_face(Index record, Index face) {
    const std::vector<std::string_view> old = words(records_.faces[record]);
    edits_.replace_integer(old[1], mesh_.soup.face_ids.of(face));
    for (std::size_t k = 0; k < 3; ++k) {
      edits_.replace_integer(old[2 + k], mesh_.soup.vertex_ids.of(mesh_.soup.triangles[face][k]));
    }
  }

  void insert_behind(const std::vector<std::size_t>& records, std::string lines) {
    if (!records.empty()) {
      edits_.insert_lines_behind(span_of(words(records.back())), std::move(lines));
    }
  }

  const EditedMesh& mesh_;
  NativeRecords records_;
  LineEdits edits_;
};

}  // namespace

RewrittenFile rewrite_mesh_format(const EditedMesh& mesh, std::string_view text) {
  require_all_vertices(mesh.soup);
  require_unambiguous_ids(mesh.soup);
  return NativeRewriter(mesh, text).rewrite();
}

}  // namespace meshalyzer
