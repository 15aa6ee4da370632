#include "meshalyzer/report/text/defect_lines.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/report/text/short_list.h"

#include <cstddef>
#include <string_view>

namespace meshalyzer {
namespace {

void append_part(std::string& text, std::string_view separator, std::string_view part) {
  if (part.empty()) return;
  if (!text.empty()) text += separator;
  text += part;
}

/// Appends `words` and n items, at most as many as a line may have.
template <typename Item>
void append_list(std::string& text, std::string_view words, std::size_t n, ListLength lists,
                 const Item& item) {
  if (n == 0) return;
  append_part(text, ", ", words);
  append_items(text, n, lists, item);
}

/// Returns the word for the faces of a defect. If it is a whole component, its first face
/// represents all of them.
std::string_view word_for_faces(const Defect& defect) {
  if (is_whole_component(defect.code)) return "component of face";
  return defect.faces.size() == 1 ? "face" : "faces";
}

std::string elements_text(const Defect& defect, const MeshName& mesh, ListLength lists) {
  const auto vertex = [&](Index v) { return std::to_string(mesh.vertex_ids.of(v)); };
  const auto face = [&](Index f) { return std::to_string(mesh.face_ids.of(f)); };
  std::string text;
  append_list(text, defect.vertices.size() == 1 ? "vertex" : "vertices", defect.vertices.size(),
              lists, [&](std::size_t i) { return vertex(defect.vertices[i]); });
  append_list(text, defect.edges.size() == 1 ? "edge" : "edges", defect.edges.size(), lists,
              [&](std::size_t i) {
                std::string edge = vertex(defect.edges[i][0]);
                edge += '-';
                edge += vertex(defect.edges[i][1]);
                return edge;
              });
  append_list(text, word_for_faces(defect), defect.faces.size(), lists,
              [&](std::size_t i) { return face(defect.faces[i]); });
  append_list(text, defect.pairs.size() == 1 ? "pair" : "pairs", defect.pairs.size(), lists,
              [&](std::size_t i) {
                std::string pair = face(defect.pairs[i].face_a);
                pair += '/';
                pair += face(defect.pairs[i].face_b);
                pair += ' ';
                pair += contact_name(defect.pairs[i].kind);
                return pair;
              });
  return text;
}

std::string place_text(const Defect& defect) {
  if (defect.positions.empty()) return "";
  std::string text = "at";
  for (const double coordinate : defect.positions.front()) {
    text += ' ';
    text += readable(coordinate);
  }
  return text;
}

/// Returns the words after the measured value. At a non-manifold vertex the fans of faces are
/// counted, not the faces at the edge.
std::string_view words_behind(const Defect& defect, const MeasuredWords& words) {
  if (defect.code == DefectCode::NonManifold && defect.edges.empty()) return "fans of faces";
  return defect.value == 1.0 ? words.one : words.many;
}

std::string measured_text(const Defect& defect) {
  if (!defect.value) return "";
  const MeasuredWords& words = catalogue_entry(defect.code).measured;
  std::string text(words.before);
  append_part(text, " ", readable(*defect.value));
  append_part(text, " ", words_behind(defect, words));
  if (defect.limit) {
    text += defect.code == DefectCode::Numbering ? ", expected " : ", limit ";
    text += readable(*defect.limit);
  }
  return text;
}

}  // namespace

std::string defect_text(const Defect& defect, const MeshName& mesh, ListLength lists) {
  std::string text = elements_text(defect, mesh, lists);
  append_part(text, "; ", defect.detail);
  append_part(text, "; ", place_text(defect));
  append_part(text, "; ", measured_text(defect));
  if (!defect.fixable) append_part(text, "; ", "no fix yet");
  return text;
}

void append_tolerances(LineSink& lines, const DefectReport& report) {
  lines.line("degeneracy tolerance", report.tolerances.degeneracy);
  lines.line("slit tolerance", report.tolerances.slit);
  lines.line("height tolerance", report.tolerances.height);
  lines.line("maximum foldover angle", report.tolerances.max_foldover_angle);
  for (const std::string& warning : report.warnings) lines.line("warning", warning);
}

void append_defects(TextLines& lines, const ListedDefects& listed, ListLength lists) {
  const DefectList& defects = listed.report.defects;
  std::size_t i = 0;
  for (const DefectCode code : all_defect_codes()) {
    std::size_t n = 0;
    for (; i < defects.size() && defects.code_of(i) == code; ++i) {
      const bool is_listed = lists == ListLength::Full || n < kShortList;
      if (!is_listed || !listed.codes.contains(code)) continue;
      lines.line(defect_name(code), defect_text(defects[i], listed.mesh, lists));
      ++n;
    }
    const std::size_t left_out = listed.codes.contains(code) ? listed.report.count(code) - n : 0;
    if (left_out == 0) continue;
    std::string rest = std::to_string(left_out);
    rest += ' ';
    rest += defect_name(code);
    lines.line("not listed", rest);
  }
}

}  // namespace meshalyzer
