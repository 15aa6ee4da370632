#include "meshalyzer/checks/defect_sentence.h"

#include "meshalyzer/base/enum_table.h"
#include "meshalyzer/base/grouped_digits.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// Up to this many elements are all named by their ids; if there are more, only the first is.
constexpr std::size_t kMaxNamed = 3;

/// Names the elements of a defect by the ids of the file.
class Names {
 public:
  Names(const Defect& defect, const Soup& soup, bool is_at_least)
      : defect_(defect), soup_(soup), bound_(is_at_least ? "at least " : "") {}

  [[nodiscard]] std::string vertex(std::size_t i = 0) const {
    return fmt::format("vertex {}", soup_.vertex_ids.of(defect_.vertices[i]));
  }
  [[nodiscard]] std::string edge(std::size_t i = 0) const {
    return fmt::format("edge {}-{}", soup_.vertex_ids.of(defect_.edges[i][0]),
                       soup_.vertex_ids.of(defect_.edges[i][1]));
  }
  [[nodiscard]] std::string face(std::size_t i = 0) const {
    return fmt::format("face {}", id_of_face(i));
  }
  /// Returns "face 3", "faces 3, 4, 5" or "12 faces from face 3 on".
  [[nodiscard]] std::string faces() const {
    const std::size_t n = defect_.faces.size();
    if (n == 1) return face();
    if (n > kMaxNamed) return fmt::format("{} faces from {} on", grouped(n), face());
    std::string text = "faces ";
    for (std::size_t i = 0; i < n; ++i) {
      text += fmt::format("{}{}", i == 0 ? "" : i + 1 == n ? " and " : ", ", id_of_face(i));
    }
    return text;
  }
  /// Returns "a border of 4 edges from edge 1-2 on".
  [[nodiscard]] std::string border() const {
    const std::size_t n = defect_.edges.size();
    return fmt::format("a border of {} edge{} from {} on", grouped(n), n == 1 ? "" : "s", edge());
  }
  /// Returns "at least " if the defect may be larger than it is known to be, else an empty text.
  [[nodiscard]] std::string_view bound() const { return bound_; }
  /// Returns a value that counts something.
  [[nodiscard]] std::string count() const {
    return grouped(static_cast<std::size_t>(*defect_.value));
  }
  [[nodiscard]] std::string value() const { return fmt::format("{:.6g}", *defect_.value + 0.0); }
  /// Returns ", below 1e-8", or an empty text if the limit is 0 or there is none.
  [[nodiscard]] std::string below_limit() const {
    return defect_.limit.value_or(0.0) > 0.0 ? fmt::format(", below {:.6g}", *defect_.limit) : "";
  }
  [[nodiscard]] const Defect& defect() const { return defect_; }

 private:
  [[nodiscard]] std::int64_t id_of_face(std::size_t i) const {
    return soup_.face_ids.of(defect_.faces[i]);
  }

  const Defect& defect_;
  const Soup& soup_;
  std::string_view bound_;
};

std::string disjoint(const Names& is) {
  return fmt::format("the component of {}, {} face{}, is apart from the largest one", is.face(),
                     is.count(), is.count() == "1" ? "" : "s");
}

std::string foldover(const Names& is) {
  return fmt::format("{} folded back onto the surface", is.faces());
}

std::string flat_facet(const Names& is) {
  return fmt::format("{} is flat: its altitude is {}{}", is.face(), is.value(), is.below_limit());
}

std::string degenerate_facet(const Names& is) {
  if (!is.defect().vertices.empty()) {
    return fmt::format("{} names {} twice", is.face(), is.vertex());
  }
  return fmt::format("{} has an edge of length {}{}", is.face(), is.value(), is.below_limit());
}

std::string slit(const Names& is) {
  return fmt::format("{} edges from {} on lie on each other and are not joined, {} apart",
                     grouped(is.defect().edges.size()), is.edge(), is.value());
}

std::string self_intersection(const Names& is) {
  const std::size_t n = is.defect().pairs.size();
  return n == 1 ? fmt::format("{}{} intersect", is.bound(), is.faces())
                : fmt::format("{}{} intersect in {}{} pairs", is.bound(), is.faces(), is.bound(),
                              grouped(n));
}

std::string non_manifold(const Names& is) {
  return is.defect().edges.empty()
             ? fmt::format("{} joins {} fans of faces", is.vertex(), is.count())
             : fmt::format("{} has {} faces", is.edge(), is.count());
}

std::string vertex_normal(const Names& is) {
  return fmt::format("the normal at {} points into the mesh", is.vertex());
}

std::string corrupt(const Names& is) {
  return is.defect().detail;
}

std::string hole(const Names& is) {
  return fmt::format("{}, of length {}", is.border(), is.value());
}

std::string flipped(const Names& is) {
  const bool one = is.defect().faces.size() == 1;
  return is.defect().fixable
             ? fmt::format("{} {} turned against {} neighbours", is.faces(), one ? "is" : "are",
                           one ? "its" : "their")
             : fmt::format("no turning of faces makes the component of {} consistent", is.face());
}

std::string inward(const Names& is) {
  return fmt::format("the component of {} is inside out, its volume {}", is.face(), is.value());
}

std::string duplicate_facet(const Names& is) {
  return fmt::format("{} have the same three vertices", is.faces());
}

std::string orphan_vertex(const Names& is) {
  return fmt::format("no face uses {}", is.vertex());
}

std::string numbering(const Names& is) {
  return fmt::format("{} stands where {:.0f} should",
                     is.defect().faces.empty() ? is.vertex() : is.face(), *is.defect().limit);
}

/// The element that the sentence of a code names first.
enum class Lead { Vertex, EdgeOrVertex, Face, FaceOrVertex };

struct Sentence {
  DefectCode code;
  Lead lead;
  std::string (*text)(const Names& names);
};

constexpr std::array<Sentence, kDefectCodes> kSentences{{
    {DefectCode::Disjoint, Lead::Face, disjoint},
    {DefectCode::Foldover, Lead::Face, foldover},
    {DefectCode::FlatFacet, Lead::Face, flat_facet},
    {DefectCode::DegenerateFacet, Lead::Face, degenerate_facet},
    {DefectCode::Slit, Lead::EdgeOrVertex, slit},
    {DefectCode::SelfIntersection, Lead::Face, self_intersection},
    {DefectCode::NonManifold, Lead::EdgeOrVertex, non_manifold},
    {DefectCode::VertexNormal, Lead::Vertex, vertex_normal},
    {DefectCode::Corrupt, Lead::FaceOrVertex, corrupt},
    {DefectCode::Hole, Lead::EdgeOrVertex, hole},
    {DefectCode::Flipped, Lead::Face, flipped},
    {DefectCode::Inward, Lead::Face, inward},
    {DefectCode::DuplicateFacet, Lead::Face, duplicate_facet},
    {DefectCode::OrphanVertex, Lead::Vertex, orphan_vertex},
    {DefectCode::Numbering, Lead::FaceOrVertex, numbering},
}};

static_assert(is_in_enum_order(kSentences, &Sentence::code));

const Sentence& sentence_of(const Defect& defect) {
  return kSentences[static_cast<std::size_t>(defect.code)];
}

}  // namespace

std::string defect_sentence(const Defect& defect, const Soup& soup, bool is_at_least) {
  return sentence_of(defect).text(Names(defect, soup, is_at_least));
}

std::optional<std::size_t> record_line(const std::vector<std::uint32_t>& lines, Index record) {
  if (record >= lines.size()) return std::nullopt;
  return lines[record];
}

std::optional<std::size_t> defect_line(const Defect& defect, const Soup& soup) {
  if (defect.line) return defect.line;
  const Lead lead = sentence_of(defect).lead;
  const bool is_face_first = lead == Lead::Face || lead == Lead::FaceOrVertex;
  if (is_face_first && !defect.faces.empty()) return record_line(soup.face_lines, defect.faces[0]);
  if (lead == Lead::EdgeOrVertex && !defect.edges.empty()) {
    return record_line(soup.vertex_lines, defect.edges[0][0]);
  }
  if (!defect.vertices.empty()) return record_line(soup.vertex_lines, defect.vertices[0]);
  return std::nullopt;
}

}  // namespace meshalyzer
