#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/blend.h"
#include "meshalyzer/io/rewrite/merged_vertices.h"
#include "meshalyzer/io/rewrite/obj_attributes.h"
#include "meshalyzer/io/rewrite/rewriters.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns a new index in the notation of an old one: counted from the first record, or backwards
/// from the last.
std::string reference_text(std::string_view old, Index index, std::size_t n_so_far) {
  const std::int64_t number = old.front() == '-'
                                  ? std::int64_t{index} - static_cast<std::int64_t>(n_so_far)
                                  : std::int64_t{index} + 1;
  return parse_integer(old) == number ? std::string(old) : std::to_string(number);
}

/// Returns, for each old vertex and for the end, how many of the vertices before it are kept.
///
/// @param numbers  The new number of each old vertex, ascending; kNoIndex for dropped ones.
std::vector<Index> count_kept(const std::vector<Index>& numbers) {
  std::vector<Index> counts{0};
  counts.reserve(numbers.size() + 1);
  for (const Index number : numbers) {
    counts.push_back(number == kNoIndex ? counts.back() : number + 1);
  }
  return counts;
}

class ObjRewriter {
 public:
  ObjRewriter(const EditedMesh& mesh, std::string_view text)
      : mesh_(mesh),
        records_(find_obj_records(text)),
        plan_(plan_faces(mesh, records_.face_records)),
        numbers_(new_vertices(mesh)),
        merges_(find_vertex_merges(mesh, numbers_)),
        n_kept_before_(count_kept(numbers_)),
        attributes_(mesh, text, records_),
        edits_(text) {}

  RewrittenFile rewrite() {
    edit_vertices();
    write_faces();
    settle_new_records();
    for (Index r = 0; r < plan_.changes.size(); ++r) {
      edit_face(r);
    }
    edit_naming();
    insert_behind(records_.vertices, added_vertices());
    insert_behind(records_.texture_points, lines_of("vt", attributes_.new_texture_points()));
    insert_behind(records_.normals, lines_of("vn", attributes_.new_normals()));
    RewrittenFile file = rewritten_file(edits_, plan_);
    note_merged(file.lost);
    return file;
  }

 private:
  [[nodiscard]] std::vector<std::string_view> words(std::size_t statement) const {
    return words_at(edits_.source(), statement, Continuation::Backslash);
  }

  void edit_vertices() {
    for (std::size_t r = 0; r < records_.vertices.size(); ++r) {
      const Index v = numbers_[r];
      if (v == kNoIndex) {
        edits_.replace_lines(span_of(words(records_.vertices[r])), {});
        continue;
      }
      const Vec3& before = mesh_.source.positions[r];
      const Vec3& now = mesh_.soup.positions[v];
      if (now != before) {
        const std::vector<std::string_view> old = words(records_.vertices[r]);
        edits_.replace_numbers(std::span(old).subspan(1), {before.data(), 3}, {now.data(), 3});
      }
    }
  }

  [[nodiscard]] std::string added_vertices() const {
    std::string lines;
    const std::vector<Blend> blends = added_vertex_blends(mesh_);
    const std::size_t n_old = mesh_.vertices.size() - blends.size();
    for (std::size_t i = 0; i < blends.size(); ++i) {
      lines += 'v';
      for (const double coordinate : mesh_.soup.positions[n_old + i]) {
        lines += ' ';
        append_shortest(lines, coordinate);
      }
      append_extra(lines, blends[i]);
      lines += edits_.line_end();
    }
    return lines;
  }

  /// Returns the numbers after a position: weight, colour, both, or none.
  [[nodiscard]] std::vector<std::string_view> extra(Index vertex) const {
    std::vector<std::string_view> all = words(records_.vertices[vertex]);
    all.erase(all.begin(), all.begin() + 4);
    return all;
  }

  /// Counts what vertices had that were merged into others.
  void note_merged(std::vector<AttributeCount>& lost) const {
    bool has_lost_weight = false;
    for (const MergedVertex& merged : merges_.merged) {
      const std::vector<std::string_view> before = extra(merged.gone);
      const std::vector<std::string_view> after = extra(merged.kept);
      const std::size_t n_before = before.size() < 3 ? 0 : 3;
      const std::size_t n_after = after.size() < 3 ? 0 : 3;
      if (are_lost_in(std::span(before).last(n_before), std::span(after).last(n_after))) {
        lost.push_back({AttributeKind::VertexColours, 1});
      }
      has_lost_weight = has_lost_weight || weight_of(before) != weight_of(after);
    }
    lost.push_back({AttributeKind::VertexProperties, has_lost_weight ? 1U : 0U});
  }

  /// Returns the weight among the numbers after a position, which is 1 if there is none.
  [[nodiscard]] static double weight_of(const std::vector<std::string_view>& extra) {
    return extra.size() % 3 == 1 ? parse_real(extra.front()).value_or(1.0) : 1.0;
  }

  /// Appends the numbers after a position: weight and colour, if all vertices of the blend have
  /// them.
  void append_extra(std::string& line, const Blend& blend) const {
    if (blend.is_empty()) {
      return;
    }
    const std::vector<std::string_view> first = extra(blend.items[0]);
    for (const Index item : blend.items) {
      if (item != kNoIndex && extra(item).size() != first.size()) {
        return;
      }
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto number = [&](Index item) { return parse_real(extra(item)[i]).value_or(0.0); };
      line += ' ';
      line += blend.is_single() ? std::string(first[i]) : shortest(blend.mean(number));
    }
  }

  /// Replaces dropped records by their remaining triangles, and inserts added faces.
  void write_faces() {
    auto next = plan_.written.begin();
    for (Index r = 0; r < plan_.changes.size(); ++r) {
      const bool is_dropped = plan_.changes[r] == RecordChange::Dropped;
      if (!is_dropped && (next == plan_.written.end() || next->record != r)) {
        continue;
      }
      std::string lines;
      for (; next != plan_.written.end() && next->record == r; ++next) {
        lines += face_line(next->face);
      }
      const std::string_view record = span_of(words(records_.faces[r]));
      if (is_dropped) {
        edits_.replace_lines(record, std::move(lines));
      } else {
        edits_.insert_lines_behind(record, std::move(lines));
      }
    }
    std::string rest;
    for (; next != plan_.written.end(); ++next) {
      rest += face_line(next->face);
    }
    insert_behind(records_.faces, std::move(rest));
  }

  /// Adds the new records that kept faces name: their number must be known before statements that
  /// count backwards are edited.
  void settle_new_records() {
    for (Index r = 0; records_.has_relative_faces && r < plan_.changes.size(); ++r) {
      if (plan_.changes[r] == RecordChange::Dropped) {
        continue;
      }
      const std::vector<std::string_view> old = words(records_.faces[r]);
      const ObjCounts counts = records_.counts_before(records_.faces[r]);
      for (std::size_t i = 1; i < old.size(); ++i) {
        const ObjCorner named = parse_obj_corner(old[i], counts, TextScanner(old[i]));
        static_cast<void>(corner_now(r, i - 1, named));
      }
    }
  }

  [[nodiscard]] bool keeps_normals(Index record) {
    if (mesh_.soup.corner_normals.empty() || mesh_.source.corner_normals.empty()) {
      return true;
    }
    bool keeps = true;
    for (std::size_t local = 0; local < records_.face_records.n_triangles(record) + 2; ++local) {
      const FanCorner corner = fan_corner(records_.face_records, record, local);
      ObjCorner named;
      named.vertex = mesh_.source.triangles[corner.triangle][corner.corner];
      named.normal = mesh_.source.corner_normals[corner.triangle][corner.corner];
      keeps = corner_now(record, local, named).normal == named.normal && keeps;
    }
    return keeps;
  }

  [[nodiscard]] std::string face_line(Index face) {
    std::array<ObjCorner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = attributes_.corner({face, k});
    }
    // A face has texture coordinates and normals at all of its corners, or at none.
    const bool has_texture = std::all_of(corners.begin(), corners.end(), [](const ObjCorner& c) {
      return c.texture_point != kNoIndex;
    });
    const bool has_normals = std::all_of(corners.begin(), corners.end(),
                                         [](const ObjCorner& c) { return c.normal != kNoIndex; });
    std::string line = "f";
    for (const ObjCorner& corner : corners) {
      line += ' ' + std::to_string(std::uint64_t{corner.vertex} + 1);
      if (has_texture) {
        line += '/' + std::to_string(std::uint64_t{corner.texture_point} + 1);
      }
      if (has_normals) {
        line += has_texture ? "/" : "//";
        line += std::to_string(std::uint64_t{corner.normal} + 1);
      }
    }
    return line + edits_.line_end();
  }

  void edit_face(Index record) {
    const RecordChange change = plan_.changes[record];
    if (change == RecordChange::Dropped) {
      return;
    }
    if (change == RecordChange::Kept && !records_.has_relative_faces &&
        !is_renumbered(mesh_, plan_, records_.face_records, record) && keeps_normals(record)) {
      return;
    }
    const std::vector<std::string_view> old = words(records_.faces[record]);
    const ObjCounts counts = records_.counts_before(records_.faces[record]);
    const std::size_t n = old.size() - 1;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t local = corner_written_at(plan_, record, i, n);
      const ObjCorner named = parse_obj_corner(old[1 + local], counts, TextScanner(old[1 + local]));
      edits_.replace(old[1 + i],
                     corner_text(old[1 + local], corner_now(record, local, named), counts));
    }
  }

  /// Returns the records that a corner of a kept record names now.
  [[nodiscard]] ObjCorner corner_now(Index record, std::size_t local, const ObjCorner& named) {
    const FanCorner corner = fan_corner(records_.face_records, record, local);
    const Index face = plan_.faces[corner.triangle];
    const Index vertex = named.vertex < numbers_.size() ? numbers_[named.vertex] : kNoIndex;
    const Triangle& now = mesh_.soup.triangles[face];
    // The triangles of a reversed polygon have the same vertices at other corners.
    const std::size_t k =
        plan_.changes[record] == RecordChange::Turned
            ? static_cast<std::size_t>(std::find(now.begin(), now.end(), vertex) - now.begin())
            : corner.corner;
    if (vertex != kNoIndex && now[k] == vertex) {
      const Index normal = attributes_.normal({face, k}, named.normal);
      return {vertex, named.texture_point, normal == kNoIndex ? named.normal : normal};
    }
    return attributes_.corner({face, corner.corner});
  }

  /// Returns a corner in the notation of an old one.
  [[nodiscard]] std::string corner_text(std::string_view old, const ObjCorner& now,
                                        const ObjCounts& counts) const {
    const std::size_t first_slash = std::min(old.find('/'), old.size());
    const std::size_t second_slash = std::min(old.find('/', first_slash + 1), old.size());
    const ObjCounts n_so_far = new_counts(counts);
    std::string text = reference_text(old.substr(0, first_slash), now.vertex, n_so_far.vertices);
    text += old.substr(first_slash, 1);
    const std::string_view texture_point =
        old.substr(std::min(first_slash + 1, second_slash), second_slash - first_slash - 1);
    if (!texture_point.empty() && now.texture_point != kNoIndex) {
      text += reference_text(texture_point, now.texture_point, n_so_far.texture_points);
    }
    text += old.substr(second_slash, 1);
    const std::string_view normal = old.substr(std::min(second_slash + 1, old.size()));
    if (!normal.empty() && now.normal != kNoIndex) {
      text += reference_text(normal, now.normal, n_so_far.normals);
    }
    return text;
  }

  /// Returns the numbers of records before a statement after the edits.
  [[nodiscard]] ObjCounts new_counts(const ObjCounts& old) const {
    ObjCounts counts = old;
    counts.vertices = n_kept_before_[old.vertices];
    if (old.vertices == records_.vertices.size()) {
      counts.vertices = mesh_.soup.n_vertices();
    }
    if (old.texture_points == records_.texture_points.size()) {
      counts.texture_points += attributes_.new_texture_points().size();
    }
    if (old.normals == records_.normals.size()) {
      counts.normals += attributes_.new_normals().size();
    }
    return counts;
  }

  /// Moves the numbers of vertices in lines, points, curves and surfaces, and drops those that have
  /// lost a vertex.
  void edit_naming() {
    bool has_lost_surface = false;
    for (const ObjNaming& statement : records_.naming) {
      const bool is_kept = rename(statement);
      if (!is_kept) {
        drop(statement.begin, statement.kind);
        for (const std::size_t part : statement.body) drop(part, statement.kind);
        has_lost_surface = has_lost_surface || words(statement.begin)[0] == "surf";
      }
    }
    // The numbers of the surfaces behind it are others now.
    for (std::size_t i = 0; has_lost_surface && i < records_.connections.size(); ++i) {
      drop(records_.connections[i], AttributeKind::OtherStatements);
    }
  }

  void drop(std::size_t statement, AttributeKind kind) {
    const std::vector<std::string_view> all = words(statement);
    edits_.replace_lines(span_of(all), {});
    edits_.note_loss(kind, span_of(all));
  }

  /// Returns false if a vertex that the statement names was dropped, or merged into another one
  /// that it names.
  bool rename(const ObjNaming& statement) {
    const std::vector<std::string_view> old = words(statement.begin);
    const ObjCounts counts = records_.counts_before(statement.begin);
    std::vector<ObjCorner> all;
    std::vector<Index> names;
    for (std::size_t i = statement.n_before; i < old.size(); ++i) {
      const std::optional<ObjCorner> named = corner_of(old[i], counts);
      if (!named || named->vertex >= merges_.names.size()) {
        return true;
      }
      if (merges_.names[named->vertex] == kNoIndex) {
        return false;
      }
      names.push_back(named->vertex);
      all.push_back({merges_.names[named->vertex], named->texture_point, named->normal});
    }
    if (are_joined(names, merges_.names)) {
      return false;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string_view word = old[statement.n_before + i];
      edits_.replace(word, corner_text(word, all[i], counts));
    }
    return true;
  }

  /// Returns the corner of a statement other than a face, or nothing if it is malformed, since the
  /// reader skips these statements.
  [[nodiscard]] static std::optional<ObjCorner> corner_of(std::string_view word,
                                                          const ObjCounts& counts) {
    try {
      return parse_obj_corner(word, counts, TextScanner(word));
    } catch (const TextFault&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] std::string lines_of(std::string_view keyword,
                                     const std::vector<std::string>& values) const {
    std::string lines;
    for (const std::string& value : values) {
      lines += keyword;
      lines += value;
      lines += edits_.line_end();
    }
    return lines;
  }

  /// Inserts lines after the last statement of a kind, or at the beginning if there is none.
  void insert_behind(const std::vector<std::size_t>& statements, std::string lines) {
    if (statements.empty()) {
      edits_.insert(0, std::move(lines));
    } else {
      edits_.insert_lines_behind(span_of(words(statements.back())), std::move(lines));
    }
  }

  const EditedMesh& mesh_;
  ObjRecords records_;
  FacePlan plan_;
  /// The new number of each vertex record; kNoIndex if it was dropped.
  std::vector<Index> numbers_;
  VertexMerges merges_;
  /// #old vertices + 1: how many of those before each are kept.
  std::vector<Index> n_kept_before_;
  ObjAttributes attributes_;
  LineEdits edits_;
};

}  // namespace

RewrittenFile rewrite_obj(const EditedMesh& mesh, std::string_view text) {
  require_all_vertices(mesh.soup);
  return ObjRewriter(mesh, text).rewrite();
}

}  // namespace meshalyzer
