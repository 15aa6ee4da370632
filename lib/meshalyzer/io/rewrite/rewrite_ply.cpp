#include "meshalyzer/io/ply_names.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/blend.h"
#include "meshalyzer/io/rewrite/merged_vertices.h"
#include "meshalyzer/io/rewrite/ply_corner_lists.h"
#include "meshalyzer/io/rewrite/ply_edits.h"
#include "meshalyzer/io/rewrite/ply_records.h"
#include "meshalyzer/io/rewrite/rewriters.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The properties by which other elements name vertices.
constexpr std::array<std::string_view, 4> kVertexReferences = {"vertex1", "vertex2", "vertex_index",
                                                               "vertex_indices"};

std::size_t find_element(const PlyHeader& header, std::string_view name) {
  return static_cast<std::size_t>(
      std::find_if(header.elements.begin(), header.elements.end(),
                   [&](const PlyElement& element) { return element.name == name; }) -
      header.elements.begin());
}

class PlyRewriter {
 public:
  PlyRewriter(const EditedMesh& mesh, std::string_view content, const PlyHeader& header)
      : mesh_(mesh),
        header_(header),
        records_(content, header),
        vertex_(find_element(header, "vertex")),
        face_(find_element(header, "face")),
        numbers_(new_vertices(mesh)),
        merges_(find_vertex_merges(mesh, numbers_)),
        has_normals_(has_vertex_normals(mesh.source)),
        edits_(content, records_.is_ascii()) {
    const bool has_faces = face_ != header.elements.size();
    if (has_faces) {
      corners_ = find_corner_list(header.elements[face_]);
      face_records_ = face_records_of(records_, face_, corners_);
    }
    plan_ = plan_faces(mesh, face_records_);
    if (has_faces) {
      lists_.emplace(mesh, records_, PlyFaces{header.elements[face_], face_, corners_},
                     face_records_);
    }
  }

  RewrittenFile rewrite() {
    if (vertex_ != header_.elements.size()) {
      widen_coordinates();
      edit_vertices();
    }
    if (face_ != header_.elements.size()) {
      widen_indices();
      edit_faces();
    }
    for (std::size_t e = 0; e < header_.elements.size(); ++e) {
      if (e != vertex_ && e != face_) {
        edit_element(e);
      }
    }
    RewrittenFile file = rewritten_file(edits_, plan_);
    note_merged(file.lost);
    return file;
  }

 private:
  [[nodiscard]] const std::vector<PlyProperty>& properties(std::size_t element) const {
    return header_.elements[element].properties;
  }

  void set_count(std::size_t element, std::size_t count) {
    edits_.replace_integer(declaration_of(edits_.source(), header_.elements[element]).at(2),
                           static_cast<std::int64_t>(count));
  }

  /// Declares a property with another type.
  void declare(std::size_t element, const PlyProperty& property, std::string type) {
    const std::vector<std::string_view> words =
        declaration_of(edits_.source(), header_.elements[element], property.name);
    edits_.replace(words[words.size() - 2], std::move(type));
  }

  void widen_coordinates() {
    vertex_properties_ = properties(vertex_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      PlyProperty& property =
          vertex_properties_[find_property(header_.elements[vertex_], kPlyVertexNumbers[axis])];
      const auto fits = [&](const Vec3& position) {
        return records_.fits(position[static_cast<Eigen::Index>(axis)], property.type);
      };
      if (!std::all_of(mesh_.soup.positions.begin(), mesh_.soup.positions.end(), fits)) {
        declare(vertex_, property, "double");
        property.type = PlyType::Float64;
        is_widened_ = true;
      }
    }
  }

  /// Returns the number in the soup for a property of a vertex, or nothing for other properties.
  [[nodiscard]] std::optional<double> own_number(const Soup& soup, std::size_t v,
                                                 const PlyProperty& property) const {
    const auto place = static_cast<std::size_t>(
        std::find(kPlyVertexNumbers.begin(), kPlyVertexNumbers.end(), property.name) -
        kPlyVertexNumbers.begin());
    if (place < 3) {
      return soup.positions[v][static_cast<Eigen::Index>(place)];
    }
    if (place < kPlyVertexNumbers.size() && has_normals_) {
      return soup.normals[v][static_cast<Eigen::Index>(place - 3)];
    }
    return std::nullopt;
  }

  void edit_vertices() {
    set_count(vertex_, mesh_.soup.n_vertices());
    for (Index r = 0; r < numbers_.size(); ++r) {
      if (numbers_[r] == kNoIndex) {
        edits_.replace_record(records_.read(vertex_, r).bytes, {});
      } else if (is_widened_ || !keeps_numbers(r, numbers_[r])) {
        edit_vertex(r, numbers_[r]);
      }
    }
    std::string added;
    const std::vector<Blend> blends = added_vertex_blends(mesh_);
    const std::size_t n_old = mesh_.vertices.size() - blends.size();
    for (std::size_t i = 0; i < blends.size(); ++i) {
      added += added_vertex(n_old + i, blends[i]);
    }
    if (!added.empty()) {
      const std::size_t last = records_.begins(vertex_).size() - 1;
      edits_.insert_records_behind(records_.read(vertex_, last).bytes, std::move(added));
    }
  }

  [[nodiscard]] bool keeps_numbers(Index record, Index v) const {
    return mesh_.source.positions[record] == mesh_.soup.positions[v] &&
           (!has_normals_ || mesh_.source.normals[record] == mesh_.soup.normals[v]);
  }

  void edit_vertex(Index record, Index v) {
    const PlyRecord old = records_.read(vertex_, record);
    for (std::size_t p = 0; p < old.fields.size(); ++p) {
      const PlyProperty& property = vertex_properties_[p];
      const std::optional<double> before = own_number(mesh_.source, record, property);
      const std::optional<double> now = own_number(mesh_.soup, v, property);
      if (now && (*now != *before || property.type != properties(vertex_)[p].type)) {
        edits_.replace(old.fields[p].items[0], records_.text(*now, property.type));
      }
    }
  }

  [[nodiscard]] std::string added_vertex(std::size_t v, const Blend& blend) const {
    PlyFields fields;
    for (std::size_t p = 0; p < vertex_properties_.size(); ++p) {
      const PlyProperty& property = vertex_properties_[p];
      if (const std::optional<double> own = own_number(mesh_.soup, v, property)) {
        fields.push_back(records_.text(*own, property.type));
      } else if (blend.is_empty()) {
        append_nothing(property, fields);
      } else if (property.list_size_type || has_no_mean(property.type)) {
        append_field(records_.read(vertex_, blend.main_item()).fields[p], fields);
      } else {
        const auto number = [&](Index item) {
          return records_.number(records_.read(vertex_, item).fields[p].items[0], property.type);
        };
        fields.push_back(records_.text(blend.mean(number), property.type));
      }
    }
    return edits_.joined(fields);
  }

  /// Appends an empty list or 0.
  void append_nothing(const PlyProperty& property, PlyFields& fields) const {
    fields.push_back(records_.text(0.0, property.list_size_type.value_or(property.type)));
  }

  /// Counts what vertices had that were merged into others: colours and texture coordinates a
  /// vertex, and every other property in which any of them differ.
  void note_merged(std::vector<AttributeCount>& lost) const {
    std::set<std::size_t> other_properties;
    for (const MergedVertex& merged : merges_.merged) {
      const PlyRecord before = records_.read(vertex_, merged.gone);
      const PlyRecord after = records_.read(vertex_, merged.kept);
      bool has_lost_colour = false;
      bool has_lost_texture = false;
      for (std::size_t p = 0; p < before.fields.size(); ++p) {
        const PlyProperty& property = properties(vertex_)[p];
        if (own_number(mesh_.source, merged.gone, property) ||
            has_same_numbers(before.fields[p], after.fields[p], property.type)) {
          continue;
        }
        if (is_ply_colour(property.name)) {
          has_lost_colour = true;
        } else if (is_ply_texture(property.name)) {
          has_lost_texture = true;
        } else {
          other_properties.insert(p);
        }
      }
      const bool has_lost_normal =
          has_normals_ && mesh_.source.normals[merged.gone] != mesh_.soup.normals[merged.now];
      lost.push_back({AttributeKind::VertexColours, has_lost_colour ? 1U : 0U});
      lost.push_back({AttributeKind::TextureCoordinates, has_lost_texture ? 1U : 0U});
      lost.push_back({AttributeKind::Normals, has_lost_normal ? 1U : 0U});
    }
    lost.push_back({AttributeKind::VertexProperties, other_properties.size()});
  }

  [[nodiscard]] bool has_same_numbers(const PlyField& a, const PlyField& b, PlyType type) const {
    return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(),
                      [&](std::string_view x, std::string_view y) {
                        return x == y || records_.number(x, type) == records_.number(y, type);
                      });
  }

  void widen_indices() {
    const PlyProperty& corners = properties(face_)[corners_];
    index_type_ = corners.type;
    // The largest index is one less than the number of vertices.
    if (!records_.fits(static_cast<double>(mesh_.soup.n_vertices()) - 1.0, index_type_)) {
      declare(face_, corners, "int");
      index_type_ = PlyType::Int32;
    }
  }

  void edit_faces() {
    set_count(face_, plan_.n_records);
    auto next = plan_.written.begin();
    for (Index r = 0; r < plan_.changes.size(); ++r) {
      if (plan_.changes[r] != RecordChange::Dropped) {
        edit_face(r);
        continue;
      }
      std::string left;
      for (; next != plan_.written.end() && next->record == r; ++next) {
        left += face_record(next->face);
      }
      edits_.replace_record(records_.read(face_, r).bytes, std::move(left));
    }
    std::string added;
    for (; next != plan_.written.end(); ++next) {
      added += face_record(next->face);
    }
    if (!added.empty()) {
      const std::size_t last = records_.begins(face_).size() - 1;
      edits_.insert_records_behind(records_.read(face_, last).bytes, std::move(added));
    }
  }

  [[nodiscard]] std::string index_text(Index vertex) const {
    return records_.text(vertex, index_type_);
  }

  void edit_face(Index record) {
    const bool is_turned = plan_.changes[record] == RecordChange::Turned;
    if (!is_turned && index_type_ == properties(face_)[corners_].type &&
        !is_renumbered(mesh_, plan_, face_records_, record)) {
      return;
    }
    const PlyRecord old = records_.read(face_, record);
    const std::size_t n = old.fields[corners_].items.size();
    for (std::size_t i = 0; i < n; ++i) {
      const FanCorner corner =
          fan_corner(face_records_, record, corner_written_at(plan_, record, i, n));
      const Index source_vertex = mesh_.source.triangles[corner.triangle][corner.corner];
      const Index vertex = vertex_now(mesh_, plan_, numbers_, record, corner);
      edits_.replace(old.fields[corners_].items[i], index_text(vertex));
      const bool is_other = vertex != numbers_[source_vertex];
      edit_corner_lists(old, i,
                        is_other ? lists_->blend({plan_.faces[corner.triangle], corner.corner})
                                 : single_blend(corner_number(corner)));
    }
  }

  /// Updates the entry of a corner of a kept record in the lists of the face.
  void edit_corner_lists(const PlyRecord& record, std::size_t local, const Blend& blend) {
    for (std::size_t p = 0; p < record.fields.size(); ++p) {
      if (!lists_->has_list(record, p) || blend.is_empty()) {
        continue;
      }
      const std::array<std::string, 2> numbers = lists_->numbers(blend, p);
      for (std::size_t i = 0; i < 2; ++i) {
        edits_.replace(record.fields[p].items[2 * local + i], numbers[i]);
      }
    }
  }

  /// Returns a face as a record of its own.
  [[nodiscard]] std::string face_record(Index face) {
    const ElementOrigin& origin = mesh_.faces[face];
    std::optional<PlyRecord> model;
    if (origin.record != kNoIndex) {
      model = records_.read(face_, face_records_.record_of(origin.record));
    }
    const bool is_patch = origin.relation == ElementOrigin::Relation::Beside;
    PlyFields fields;
    for (std::size_t p = 0; p < properties(face_).size(); ++p) {
      const PlyProperty& property = properties(face_)[p];
      if (p == corners_) {
        append_corners(face, fields);
      } else if (!model || (is_patch && property.list_size_type)) {
        append_nothing(property, fields);
      } else if (lists_->has_list(*model, p)) {
        append_corner_list(face, p, fields);
      } else {
        append_field(model->fields[p], fields);
      }
    }
    return edits_.joined(fields);
  }

  void append_corners(Index face, PlyFields& fields) const {
    fields.push_back(records_.text(3.0, *properties(face_)[corners_].list_size_type));
    for (const Index corner : mesh_.soup.triangles[face]) {
      fields.push_back(index_text(corner));
    }
  }

  void append_corner_list(Index face, std::size_t p, PlyFields& fields) {
    fields.push_back(records_.text(6.0, *properties(face_)[p].list_size_type));
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::string& number : lists_->numbers(lists_->blend({face, k}), p)) {
        fields.push_back(number);
      }
    }
  }

  /// Edits the records of an element that is neither vertex nor face.
  void edit_element(std::size_t element) {
    std::vector<std::size_t> references;
    for (std::size_t p = 0; p < properties(element).size(); ++p) {
      if (is_one_of(properties(element)[p].name, kVertexReferences)) {
        references.push_back(p);
      }
    }
    std::size_t n_dropped = 0;
    const std::size_t n = references.empty() ? 0 : records_.begins(element).size();
    for (std::size_t r = 0; r < n; ++r) {
      n_dropped += edit_references(element, records_.read(element, r), references) ? 0 : 1;
    }
    if (n_dropped != 0) {
      set_count(element, n - n_dropped);
    }
  }

  /// Renumbers the vertices that a record names. If one was dropped, merged into another that it
  /// names, or has a number now that its type cannot hold, drops the record and returns false.
  bool edit_references(std::size_t element, const PlyRecord& record,
                       const std::vector<std::size_t>& references) {
    std::vector<std::pair<std::string_view, std::string>> renumbered;
    std::vector<Index> named;
    bool is_kept = true;
    for (const std::size_t p : references) {
      const PlyType type = properties(element)[p].type;
      for (const std::string_view item : record.fields[p].items) {
        const double old = records_.number(item, type);
        if (!(old >= 0.0 && old < static_cast<double>(merges_.names.size()))) {
          continue;
        }
        named.push_back(static_cast<Index>(old));
        const Index now = merges_.names[named.back()];
        is_kept = is_kept && now != kNoIndex && records_.fits(now, type);
        if (is_kept && now != named.back()) {
          renumbered.emplace_back(item, records_.text(now, type));
        }
      }
    }
    if (!is_kept || are_joined(named, merges_.names)) {
      edits_.replace_record(record.bytes, {});
      edits_.note_loss(AttributeKind::OtherRecords, record.bytes);
      return false;
    }
    for (auto& [item, text] : renumbered) {
      edits_.replace(item, std::move(text));
    }
    return true;
  }

  const EditedMesh& mesh_;
  const PlyHeader& header_;
  PlyRecords records_;
  /// The number of the element `vertex`, or the number of elements if there is none.
  std::size_t vertex_;
  std::size_t face_;
  /// The property of faces that lists their corners.
  std::size_t corners_ = 0;
  FaceRecords face_records_;
  FacePlan plan_;
  /// The corner lists; nothing if there are no faces.
  std::optional<PlyCornerLists> lists_;
  /// The new number of each vertex record; kNoIndex if it was dropped.
  std::vector<Index> numbers_;
  VertexMerges merges_;
  bool has_normals_;
  bool is_widened_ = false;
  /// The properties of vertices as they are written.
  std::vector<PlyProperty> vertex_properties_;
  PlyType index_type_ = PlyType::Int32;
  PlyEdits edits_;
};

}  // namespace

std::optional<RewrittenFile> rewrite_ply(const EditedMesh& mesh, std::string_view content) {
  require_all_vertices(mesh.soup);
  const PlyHeader header = parse_ply_header(content);
  if (find_element(header, "tristrips") != header.elements.size()) {
    return std::nullopt;
  }
  return PlyRewriter(mesh, content, header).rewrite();
}

}  // namespace meshalyzer
