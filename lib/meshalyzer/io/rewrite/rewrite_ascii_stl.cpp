#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/face_plan.h"
#include "meshalyzer/io/rewrite/rewriters.h"
#include "meshalyzer/io/rewrite/text_lines.h"
#include "meshalyzer/io/stl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The number of words of "facet normal X Y Z outer loop vertex X Y Z ... endloop endfacet".
constexpr std::size_t kFacetWords = 21;
/// The positions of the numbers among these words: those of the normal, then of the corners.
constexpr std::array<std::size_t, 12> kNumberWords = {2, 3, 4, 8, 9, 10, 12, 13, 14, 16, 17, 18};

using FacetWords = std::array<std::string_view, kFacetWords>;

/// Reads the words of the next facet.
FacetWords read_facet(TextScanner& in) {
  FacetWords words;
  for (std::string_view& word : words) {
    static_cast<void>(in.next_record());
    word = in.word();
  }
  return words;
}

/// The positions of the facets.
struct StlRecords {
  std::vector<std::size_t> facets;
  FaceRecords face_records;
};

StlRecords find_facets(std::string_view text) {
  StlRecords records;
  TextScanner in(text);
  while (in.next_record()) {
    const std::size_t begin = text.size() - in.remaining();
    // Only the keyword of a facet can begin with this letter here.
    const char letter = in.peek().front();
    if (letter == 'f' || letter == 'F') {
      records.facets.push_back(begin);
      records.face_records.append(3);
      static_cast<void>(read_facet(in));
      continue;
    }
    in.skip_record();
    const std::size_t n = records.facets.size();
    records.face_records.run_ends.resize(n, static_cast<Index>(n - 1));
  }
  return records;
}

class AsciiStlRewriter {
 public:
  AsciiStlRewriter(const EditedMesh& mesh, std::string_view text)
      : mesh_(mesh),
        records_(find_facets(text)),
        plan_(plan_faces(mesh, records_.face_records)),
        edits_(text) {}

  RewrittenFile rewrite() {
    auto next = plan_.written.begin();
    for (Index r = 0; r < plan_.faces.size(); ++r) {
      std::vector<Index> added;
      for (; next != plan_.written.end() && next->record == r; ++next) {
        if (next->face != plan_.faces[r]) {
          added.push_back(next->face);
        }
      }
      edit_record(r, plan_.faces[r], added);
    }
    return rewritten_file(edits_, plan_);
  }

 private:
  [[nodiscard]] FacetWords words(Index record) const {
    TextScanner in(edits_.source().substr(records_.facets[record]));
    return read_facet(in);
  }
  [[nodiscard]] std::size_t end_of(const FacetWords& words) const {
    return edits_.offset_of(words.back()) + words.back().size();
  }

  /// Returns the numbers of a face as text, in the order of kNumberWords. Coordinates that the
  /// facet of a record has too keep its words.
  [[nodiscard]] std::vector<std::string> numbers_of(Index record, Index face) const {
    std::vector<std::string> numbers;
    for (const double number : unit_normal(mesh_.soup, mesh_.soup.triangles[face])) {
      numbers.push_back(shortest(number));
    }
    const FacetWords old = words(record);
    const Corners before = corners_of(mesh_.source, record);
    const Corners now = corners_of(mesh_.soup, face);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto* const same = std::find(before.begin(), before.end(), now[k]);
      const std::size_t model =
          same == before.end() ? k : static_cast<std::size_t>(same - before.begin());
      for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        const bool stays = before[model][axis] == now[k][axis];
        numbers.push_back(stays ? std::string(old[kNumberWords[3 + 3 * model + i]])
                                : shortest(now[k][axis]));
      }
    }
    return numbers;
  }

  /// @param face   The current face of the facet; kNoIndex if it is dropped.
  /// @param added  The faces that follow it, or replace it.
  void edit_record(Index record, Index face, const std::vector<Index>& added) {
    const std::size_t begin = records_.facets[record];
    const std::size_t end = end_of(words(record));
    if (face == kNoIndex && added.empty()) {
      edits_.erase_with_lines(edits_.source().substr(begin, end - begin));
      return;
    }
    // The comments in a facet stay in the first of those that are made of it.
    const bool keeps_comments =
        face == kNoIndex && mesh_.faces[added.front()].relation == ElementOrigin::Relation::MadeOf;
    std::string behind;
    for (const Index f : added) {
      behind += edits_.line_end();
      behind += indentation(record);
      behind += facet_like(record, f, keeps_comments && f == added.front());
    }
    if (face == kNoIndex) {
      const std::size_t blanks = edits_.line_end().size() + indentation(record).size();
      if (!keeps_comments) {
        edits_.note_lost_comments(edits_.source().substr(begin, end - begin));
      }
      edits_.replace(begin, end, behind.substr(blanks));
      return;
    }
    edits_.insert(end, std::move(behind));
    if (corners_of(mesh_.soup, face) != corners_of(mesh_.source, record)) {
      edit_numbers(record, face);
    }
  }

  void edit_numbers(Index record, Index face) {
    const FacetWords old = words(record);
    const std::vector<std::string> numbers = numbers_of(record, face);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      edits_.replace(old[kNumberWords[i]], numbers[i]);
    }
  }

  [[nodiscard]] std::string_view indentation(Index record) const {
    const std::size_t begin = records_.facets[record];
    const std::size_t blanks = edits_.source().substr(0, begin).find_last_not_of(" \t") + 1;
    return edits_.source().substr(blanks, begin - blanks);
  }

  /// Returns the text of a facet with the numbers of another face.
  [[nodiscard]] std::string facet_like(Index record, Index face, bool with_comments) const {
    const FacetWords model = words(record);
    const std::vector<std::string> numbers = numbers_of(record, face);
    std::string facet(model.front());
    auto number = numbers.begin();
    for (std::size_t i = 1; i < model.size(); ++i) {
      facet += between(model[i - 1], model[i], with_comments);
      const bool is_number =
          std::find(kNumberWords.begin(), kNumberWords.end(), i) != kNumberWords.end();
      facet += is_number ? std::string_view(*number++) : model[i];
    }
    return facet;
  }

  /// Returns what stands between two words.
  [[nodiscard]] std::string between(std::string_view word, std::string_view next,
                                    bool with_comments) const {
    const std::size_t begin = edits_.offset_of(word) + word.size();
    std::string text(edits_.source().substr(begin, edits_.offset_of(next) - begin));
    if (with_comments) {
      return text;
    }
    for (std::size_t mark = text.find('#'); mark != std::string::npos; mark = text.find('#')) {
      std::size_t end = text.find('\n', mark);
      end -= text[end - 1] == '\r' ? 1 : 0;
      const std::size_t first = text.find_last_not_of(" \t", mark - 1) + 1;
      text.erase(first, end - first);
    }
    return text;
  }

  const EditedMesh& mesh_;
  StlRecords records_;
  FacePlan plan_;
  LineEdits edits_;
};

}  // namespace

RewrittenFile rewrite_ascii_stl(const EditedMesh& mesh, std::string_view text) {
  require_all_vertices(mesh.soup);
  return AsciiStlRewriter(mesh, text).rewrite();
}

}  // namespace meshalyzer
