#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/blend.h"
#include "meshalyzer/io/rewrite/face_plan.h"
#include "meshalyzer/io/rewrite/merged_vertices.h"
#include "meshalyzer/io/rewrite/off_records.h"
#include "meshalyzer/io/rewrite/rewriters.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

class OffRewriter {
 public:
  OffRewriter(const EditedMesh& mesh, std::string_view text)
      : mesh_(mesh),
        records_(find_off_records(text, mesh.source.n_vertices())),
        plan_(plan_faces(mesh, records_.face_records)),
        numbers_(new_vertices(mesh)),
        n_vertex_numbers_(has_vertex_normals(mesh.source) ? 6 : 3),
        edits_(text) {}

  RewrittenFile rewrite() {
    edits_.replace_integer(records_.n_vertices, static_cast<std::int64_t>(mesh_.soup.n_vertices()));
    edits_.replace_integer(records_.n_faces, static_cast<std::int64_t>(plan_.n_records));
    for (Index r = 0; r < numbers_.size(); ++r) {
      edit_vertex(r);
    }
    edits_.insert_lines_behind(last_of(records_.vertices), added_vertices());
    write_faces();
    RewrittenFile file = rewritten_file(edits_, plan_);
    note_merged(file.lost);
    return file;
  }

 private:
  using Words = std::vector<std::string_view>;

  [[nodiscard]] Words words(std::size_t record) const {
    return words_at(edits_.source(), record, Continuation::None);
  }

  /// Returns the last of some records, or the line of counts if there is none.
  [[nodiscard]] std::string_view last_of(const std::vector<std::size_t>& records) const {
    return records.empty() ? records_.n_faces : span_of(words(records.back()));
  }

  /// Returns the position and, if each vertex has one, the normal.
  [[nodiscard]] std::vector<double> numbers_of(const Soup& soup, std::size_t v) const {
    std::vector<double> numbers(soup.positions[v].begin(), soup.positions[v].end());
    if (n_vertex_numbers_ == 6) {
      numbers.insert(numbers.end(), soup.normals[v].begin(), soup.normals[v].end());
    }
    return numbers;
  }

  void edit_vertex(Index record) {
    const Index v = numbers_[record];
    if (v == kNoIndex) {
      edits_.replace_lines(span_of(words(records_.vertices[record])), {});
      return;
    }
    const std::vector<double> before = numbers_of(mesh_.source, record);
    const std::vector<double> now = numbers_of(mesh_.soup, v);
    if (before == now) {
      return;
    }
    edits_.replace_numbers(words(records_.vertices[record]), before, now);
  }

  [[nodiscard]] std::string added_vertices() const {
    std::string lines;
    const std::vector<Blend> blends = added_vertex_blends(mesh_);
    const std::size_t n_old = mesh_.vertices.size() - blends.size();
    const bool has_bytes = !blends.empty() && has_byte_colours();
    for (std::size_t i = 0; i < blends.size(); ++i) {
      for (const double number : numbers_of(mesh_.soup, n_old + i)) {
        append_shortest(lines, number);
        lines += ' ';
      }
      append_extra(lines, blends[i], has_bytes);
      lines.pop_back();
      lines += edits_.line_end();
    }
    return lines;
  }

  /// Returns the colour and the texture coordinates of a vertex of the source.
  [[nodiscard]] Words extra_of(Index vertex) const {
    Words all = words(records_.vertices[vertex]);
    all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n_vertex_numbers_));
    return all;
  }

  /// Returns the colour, without the texture coordinates that follow it.
  [[nodiscard]] std::span<const std::string_view> colour_in(const Words& extra) const {
    return std::span(extra).first(extra.size() - (records_.layout.texture ? 2 : 0));
  }

  [[nodiscard]] bool has_byte_colours() const {
    for (Index v = 0; v < records_.vertices.size(); ++v) {
      if (is_byte_colour(colour_in(extra_of(v)))) return true;
    }
    return false;
  }

  /// Appends what each vertex must have, for one that has nothing of the source: white, and a point
  /// of the texture.
  void append_required(std::string& line, bool has_bytes) const {
    if (records_.layout.colour) line += has_bytes ? "255 255 255 255 " : "1.0 1.0 1.0 1.0 ";
    if (records_.layout.texture) line += "0 0 ";
  }

  /// Appends colours and texture coordinates, each number followed by a blank. Means of bytes are
  /// whole.
  void append_extra(std::string& line, const Blend& blend, bool has_bytes) const {
    if (blend.is_empty()) {
      append_required(line, has_bytes);
      return;
    }
    const Words first = extra_of(blend.items[0]);
    const std::size_t n_colour = colour_in(first).size();
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto number = [&](Index item) {
        const Words all = extra_of(item);
        return i < all.size() ? parse_real(all[i]).value_or(0.0) : 0.0;
      };
      if (blend.is_single()) {
        line += first[i];
      } else if (i >= n_colour) {
        line += shortest(blend.mean(number));
      } else if (has_bytes && parse_integer(first[i])) {
        line += shortest(std::round(blend.mean(number)));
      } else {
        line += off_intensity(blend.mean(number));
      }
      line += ' ';
    }
  }

  /// Counts what vertices had that were merged into others.
  void note_merged(std::vector<AttributeCount>& lost) const {
    const std::size_t n_texture = records_.layout.texture ? 2 : 0;
    const VertexMerges merges = find_vertex_merges(mesh_, numbers_);
    for (const auto& [gone, now, kept] : merges.merged) {
      const Words before = extra_of(gone);
      const Words after = extra_of(kept);
      if (are_lost_in(colour_in(before), colour_in(after))) {
        lost.push_back({AttributeKind::VertexColours, 1});
      }
      if (are_lost_in(std::span(before).last(n_texture), std::span(after).last(n_texture))) {
        lost.push_back({AttributeKind::TextureCoordinates, 1});
      }
      if (n_vertex_numbers_ == 6 && mesh_.source.normals[gone] != mesh_.soup.normals[now]) {
        lost.push_back({AttributeKind::Normals, 1});
      }
    }
  }

  void write_faces() {
    auto next = plan_.written.begin();
    for (Index r = 0; r < plan_.changes.size(); ++r) {
      if (plan_.changes[r] != RecordChange::Dropped) {
        edit_face(r);
        continue;
      }
      std::string lines;
      const Words old = words(records_.faces[r]);
      for (; next != plan_.written.end() && next->record == r; ++next) {
        lines += face_line(next->face, old);
      }
      edits_.replace_lines(span_of(old), std::move(lines));
    }
    std::string rest;
    for (; next != plan_.written.end(); ++next) {
      rest += face_line(next->face, model_of(next->face));
    }
    edits_.insert_lines_behind(last_of(records_.faces.empty() ? records_.vertices : records_.faces),
                               std::move(rest));
  }

  /// Returns the record that gives an added face its colour; empty in a hole patch.
  [[nodiscard]] Words model_of(Index face) const {
    const ElementOrigin& origin = mesh_.faces[face];
    if (origin.relation != ElementOrigin::Relation::MadeOf) {
      return {};
    }
    return words(records_.faces[records_.face_records.record_of(origin.record)]);
  }

  [[nodiscard]] std::string face_line(Index face, const Words& model) const {
    std::string line = "3";
    for (const Index corner : mesh_.soup.triangles[face]) {
      line += ' ' + std::to_string(corner);
    }
    const auto n_corners =
        model.empty() ? 0 : static_cast<std::size_t>(parse_integer(model[0]).value_or(0));
    for (std::size_t i = 1 + n_corners; i < model.size(); ++i) {
      line += ' ';
      line += model[i];
    }
    return line + edits_.line_end();
  }

  void edit_face(Index record) {
    const bool is_turned = plan_.changes[record] == RecordChange::Turned;
    if (!is_turned && !is_renumbered(mesh_, plan_, records_.face_records, record)) {
      return;
    }
    const Words old = words(records_.faces[record]);
    const auto n = static_cast<std::size_t>(parse_integer(old[0]).value_or(0));
    for (std::size_t i = 0; i < n; ++i) {
      const FanCorner corner =
          fan_corner(records_.face_records, record, corner_written_at(plan_, record, i, n));
      edits_.replace_integer(old[1 + i], vertex_now(mesh_, plan_, numbers_, record, corner));
    }
  }

  const EditedMesh& mesh_;
  OffRecords records_;
  FacePlan plan_;
  /// The new number of each vertex record; kNoIndex if it was dropped.
  std::vector<Index> numbers_;
  std::size_t n_vertex_numbers_;
  LineEdits edits_;
};

}  // namespace

RewrittenFile rewrite_off(const EditedMesh& mesh, std::string_view text) {
  require_all_vertices(mesh.soup);
  return OffRewriter(mesh, text).rewrite();
}

}  // namespace meshalyzer
