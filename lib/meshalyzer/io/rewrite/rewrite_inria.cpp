#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/blend.h"
#include "meshalyzer/io/rewrite/face_plan.h"
#include "meshalyzer/io/rewrite/inria_records.h"
#include "meshalyzer/io/rewrite/merged_vertices.h"
#include "meshalyzer/io/rewrite/rewriters.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

using Section = InriaRecords::Section;

/// The new numbers of records, from 0; kNoIndex for dropped ones.
using NewNumbers = std::vector<Index>;

class InriaRewriter {
 public:
  InriaRewriter(const EditedMesh& mesh, std::string_view text)
      : mesh_(mesh),
        records_(find_inria_records(text)),
        vertices_(new_vertices(mesh)),
        merges_(find_vertex_merges(mesh, vertices_)),
        edits_(text) {
    for (const Section& section : records_.sections) {
      const bool is_quadrilateral = section.keyword == "Quadrilaterals";
      if (!is_quadrilateral && section.keyword != "Triangles") {
        continue;
      }
      for (const std::string_view record : section.records) {
        faces_.push_back(record);
        face_records_.append(is_quadrilateral ? 4 : 3);
      }
    }
    plan_ = plan_faces(mesh, face_records_);
  }

  RewrittenFile rewrite() {
    std::size_t n_merged = 0;
    for (const Section& section : records_.sections) {
      if (section.keyword == "Vertices") {
        edit_vertices(section);
        n_merged += count_merged(section);
      }
    }
    edit_faces();
    for (const InriaNames names : {InriaNames::Vertices, InriaNames::Edges, InriaNames::Triangles,
                                   InriaNames::Quadrilaterals, InriaNames::Tetrahedra}) {
      edit_sections_that_name(names);
    }
    RewrittenFile file;
    file.bytes = edits_.apply();
    file.file_faces = file_faces();
    file.lost = {{AttributeKind::Polygons, plan_.n_split_polygons},
                 {AttributeKind::References, n_merged}};
    file.lost_records = edits_.lost();
    return file;
  }

 private:
  void set_count(const Section& section, std::size_t count) {
    edits_.replace_integer(section.count, static_cast<std::int64_t>(count));
  }

  /// Inserts records after the last one of a section; each ends with a line end.
  void append(std::string_view behind, std::string lines) {
    const std::string_view text = edits_.source();
    const std::size_t end = edits_.offset_of(behind) + behind.size();
    const std::size_t next = text.find_first_not_of(" \t\r", end);
    if (next == std::string_view::npos || text[next] == '\n' || text[next] == '#') {
      edits_.insert_lines_behind(behind, std::move(lines));
    } else if (!lines.empty()) {
      edits_.insert(end, edits_.line_end() + lines);
    }
  }

  void edit_vertices(const Section& section) {
    for (Index r = 0; r < vertices_.size(); ++r) {
      if (vertices_[r] == kNoIndex) {
        edits_.erase_with_lines(section.records[r]);
        continue;
      }
      const Vec3& before = mesh_.source.positions[r];
      const Vec3& now = mesh_.soup.positions[vertices_[r]];
      if (now != before) {
        const std::vector<std::string_view> old = inria_numbers(section.records[r]);
        edits_.replace_numbers(old, {before.data(), 3}, {now.data(), 3});
      }
    }
    std::string added;
    const std::vector<Blend> blends = added_vertex_blends(mesh_);
    const std::size_t n_old = mesh_.vertices.size() - blends.size();
    for (std::size_t i = 0; i < blends.size(); ++i) {
      for (const double coordinate : mesh_.soup.positions[n_old + i]) {
        append_shortest(added, coordinate);
        added += ' ';
      }
      added += blends[i].is_empty()
                   ? "0"
                   : std::string(inria_numbers(section.records[blends[i].main_item()])[3]);
      added += edits_.line_end();
    }
    set_count(section, mesh_.soup.n_vertices());
    if (!section.records.empty()) {
      append(section.records.back(), std::move(added));
    }
  }

  /// Counts the references of vertices that were merged into others.
  [[nodiscard]] std::size_t count_merged(const Section& section) const {
    std::size_t n = 0;
    for (const MergedVertex& merged : merges_.merged) {
      const auto reference = [&](Index record) {
        return parse_integer(inria_numbers(section.records[record]).back());
      };
      const auto gone = reference(merged.gone);
      n += gone != 0 && gone != reference(merged.kept) ? 1 : 0;
    }
    return n;
  }

  void edit_faces() {
    const std::string added = added_faces();
    Index record = 0;
    const Section* last_triangles = nullptr;
    const Section* last_faces = nullptr;
    for (const Section& section : records_.sections) {
      const bool is_triangles = section.keyword == "Triangles";
      if (!is_triangles && section.keyword != "Quadrilaterals") {
        continue;
      }
      NewNumbers& numbers = is_triangles ? triangles_ : quadrilaterals_;
      std::size_t n_kept = 0;
      for (std::size_t i = 0; i < section.records.size(); ++i, ++record) {
        const bool is_kept = edit_face(record);
        numbers.push_back(is_kept ? n_faces_of_[is_triangles ? 0 : 1]++ : kNoIndex);
        n_kept += is_kept ? 1 : 0;
      }
      last_faces = &section;
      last_triangles = is_triangles ? &section : last_triangles;
      counts_.emplace_back(&section, n_kept);
    }
    for (const auto& [section, n_kept] : counts_) {
      set_count(*section, n_kept + (section == last_triangles ? n_added_ : 0));
    }
    if (n_added_ == 0 || last_faces == nullptr) {
      return;
    }
    if (last_triangles == nullptr) {
      append(last_faces->records.back(), "Triangles" + edits_.line_end() +
                                             std::to_string(n_added_) + edits_.line_end() + added);
    } else {
      append(
          last_triangles->records.empty() ? last_triangles->count : last_triangles->records.back(),
          added);
    }
  }

  /// Edits or drops a face record. Returns true if it stays.
  bool edit_face(Index record) {
    if (plan_.changes[record] == RecordChange::Dropped) {
      edits_.erase_with_lines(faces_[record]);
      return false;
    }
    const std::vector<std::string_view> old = inria_numbers(faces_[record]);
    const std::size_t n = old.size() - 1;
    for (std::size_t i = 0; i < n; ++i) {
      const FanCorner corner =
          fan_corner(face_records_, record, corner_written_at(plan_, record, i, n));
      const Index vertex = vertex_now(mesh_, plan_, vertices_, record, corner);
      edits_.replace_integer(old[i], std::int64_t{vertex} + 1);
    }
    return true;
  }

  /// Returns the records of faces that follow all triangles.
  [[nodiscard]] std::string added_faces() {
    std::string lines;
    n_added_ = plan_.written.size();
    for (const FacePlan::WrittenFace& written : plan_.written) {
      for (const Index corner : mesh_.soup.triangles[written.face]) {
        lines += std::to_string(std::uint64_t{corner} + 1) + ' ';
      }
      const ElementOrigin& origin = mesh_.faces[written.face];
      const bool has_model = origin.relation != ElementOrigin::Relation::Beside;
      lines +=
          has_model
              ? std::string(inria_numbers(faces_[face_records_.record_of(origin.record)]).back())
              : "0";
      lines += edits_.line_end();
    }
    return lines;
  }

  [[nodiscard]] const NewNumbers& numbers_of(InriaNames names) const {
    switch (names) {
      case InriaNames::Edges:
        return edges_;
      case InriaNames::Triangles:
        return triangles_;
      case InriaNames::Quadrilaterals:
        return quadrilaterals_;
      case InriaNames::Tetrahedra:
        return tetrahedra_;
      default:
        return merges_.names;
    }
  }

  void edit_sections_that_name(InriaNames names) {
    for (const Section& section : records_.sections) {
      if (section.kind == nullptr || section.kind->names != names) {
        continue;
      }
      Index n_kept = 0;
      for (const std::string_view record : section.records) {
        const bool is_kept = rename(record, *section.kind);
        const Index number = is_kept ? n_kept : kNoIndex;
        if (section.keyword == "Edges") {
          edges_.push_back(number);
        } else if (section.keyword == "Tetrahedra") {
          tetrahedra_.push_back(number);
        }
        n_kept += is_kept ? 1 : 0;
      }
      set_count(section, n_kept);
    }
  }

  /// Updates the numbers by which a record names others. If one of those was dropped, or merged
  /// into another that it names, drops the record and returns false.
  bool rename(std::string_view record, const InriaSection& kind) {
    const NewNumbers& numbers = numbers_of(kind.names);
    const std::vector<std::string_view> old = inria_numbers(record);
    const std::size_t end = kind.n_before + kind.n_names;
    const auto index_of = [&](std::size_t i) {
      return static_cast<std::size_t>(parse_integer(old[i]).value_or(0) - 1);
    };
    std::vector<Index> named;
    bool is_kept = true;
    for (std::size_t i = kind.n_before; i < end; ++i) {
      if (index_of(i) < numbers.size()) {
        named.push_back(static_cast<Index>(index_of(i)));
        is_kept = is_kept && numbers[named.back()] != kNoIndex;
      }
    }
    if (!is_kept || are_joined(named, numbers)) {
      edits_.erase_with_lines(record);
      edits_.note_loss(AttributeKind::OtherRecords, record);
      return false;
    }
    for (std::size_t i = kind.n_before; i < end; ++i) {
      if (index_of(i) < numbers.size()) {
        edits_.replace_integer(old[i], std::int64_t{numbers[index_of(i)]} + 1);
      }
    }
    return true;
  }

  /// Returns the position of each face in the file; empty if they are in the order of the mesh.
  [[nodiscard]] std::vector<Index> file_faces() const {
    std::vector<Index> order;
    Index record = 0;
    const auto append_added = [&] {
      for (const FacePlan::WrittenFace& written : plan_.written) {
        order.push_back(written.face);
      }
    };
    const auto is_last = [&](const Section& section) {
      const auto last = std::find_if(counts_.rbegin(), counts_.rend(), [](const auto& count) {
        return count.first->keyword == "Triangles";
      });
      return last == counts_.rend() ? &section == counts_.back().first : &section == last->first;
    };
    for (const auto& [section, n_kept] : counts_) {
      for (std::size_t i = 0; i < section->records.size(); ++i, ++record) {
        append_record(record, order);
      }
      if (is_last(*section)) {
        append_added();
      }
    }
    std::vector<Index> places(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      places[order[i]] = static_cast<Index>(i);
    }
    return std::is_sorted(places.begin(), places.end()) ? std::vector<Index>{} : places;
  }

  void append_record(Index record, std::vector<Index>& order) const {
    if (plan_.changes[record] == RecordChange::Dropped) {
      return;
    }
    const std::size_t begin = order.size();
    for (Index t = face_records_.first_triangle[record];
         t < face_records_.first_triangle[record + 1]; ++t) {
      order.push_back(plan_.faces[t]);
    }
    if (plan_.changes[record] == RecordChange::Turned) {
      std::reverse(order.begin() + static_cast<std::ptrdiff_t>(begin), order.end());
    }
  }

  const EditedMesh& mesh_;
  InriaRecords records_;
  /// The records of triangles and quadrilaterals, in the order of the file.
  std::vector<std::string_view> faces_;
  FaceRecords face_records_;
  FacePlan plan_;
  NewNumbers vertices_;
  VertexMerges merges_;
  NewNumbers edges_;
  NewNumbers triangles_;
  NewNumbers quadrilaterals_;
  NewNumbers tetrahedra_;
  /// The numbers of triangles and quadrilaterals that have been numbered.
  std::array<Index, 2> n_faces_of_{};
  std::size_t n_added_ = 0;
  /// The sections of faces, and the number of their records that stay.
  std::vector<std::pair<const Section*, std::size_t>> counts_;
  LineEdits edits_;
};

}  // namespace

RewrittenFile rewrite_inria(const EditedMesh& mesh, std::string_view text) {
  require_all_vertices(mesh.soup);
  return InriaRewriter(mesh, text).rewrite();
}

}  // namespace meshalyzer
