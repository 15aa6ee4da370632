#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/mesh/repeated_ids.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns "<before><number><after>".
std::string sentence(std::string_view before, std::int64_t number, std::string_view after) {
  std::string text(before);
  text += std::to_string(number);
  text += after;
  return text;
}

void add_positions(const Soup& soup, DefectList& defects) {
  if (has_finite_positions(soup)) return;
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    if (soup.positions[v].allFinite()) continue;
    Defect defect = make_defect(DefectCode::Corrupt);
    defect.vertices = {v};
    defect.detail = "a coordinate is not a finite number";
    defect.fixable = false;
    defects.push_back(defect);
  }
}

/// Returns the sets of records with the same id, each ascending, in order of their first record.
std::vector<std::vector<Index>> find_namesakes(const Ids& ids) {
  const std::vector<Index> repeated = find_repeated_ids(ids);
  if (repeated.empty()) return {};
  std::vector<std::int32_t> names;
  for (const Index record : repeated) names.push_back(ids.named[record]);
  sort_unique(names);
  std::vector<std::vector<Index>> sets;
  std::vector<Index> set_of(names.size(), kNoIndex);
  for (Index record = 0; record < ids.named.size(); ++record) {
    const auto name = std::lower_bound(names.begin(), names.end(), ids.named[record]);
    if (name == names.end() || *name != ids.named[record]) continue;
    Index& set = set_of[static_cast<std::size_t>(name - names.begin())];
    if (set == kNoIndex) {
      set = static_cast<Index>(sets.size());
      sets.emplace_back();
    }
    sets[set].push_back(record);
  }
  return sets;
}

void add_repeated_ids(const Soup& soup, DefectList& defects) {
  for (std::vector<Index>& records : find_namesakes(soup.vertex_ids)) {
    Defect defect = make_defect(DefectCode::Corrupt);
    for (const Index v : records) defect.positions.push_back(soup.positions[v]);
    defect.value = static_cast<double>(records.size());
    defect.detail =
        sentence("vertex id ", soup.vertex_ids.of(records[0]), " is given more than once");
    defect.vertices = std::move(records);
    defects.push_back(defect);
  }
  for (std::vector<Index>& records : find_namesakes(soup.face_ids)) {
    Defect defect = make_defect(DefectCode::Corrupt);
    defect.positions = middle_of_face(soup, records[0]);
    defect.value = static_cast<double>(records.size());
    defect.detail = sentence("face id ", soup.face_ids.of(records[0]), " is given more than once");
    defect.faces = std::move(records);
    defects.push_back(defect);
  }
}

void add_missing_vertices(const Soup& soup, DefectList& defects) {
  std::vector<std::pair<std::int64_t, Index>> references;
  for (const MissingReference& r : soup.missing) references.emplace_back(r.id, r.face);
  sort_unique(references);
  // The places of the first reference to each id, in order of the faces there.
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (i == 0 || references[i - 1].first != references[i].first) firsts.push_back(i);
  }
  std::stable_sort(firsts.begin(), firsts.end(), [&](std::size_t a, std::size_t b) {
    return references[a].second < references[b].second;
  });
  for (std::size_t i : firsts) {
    const std::int64_t id = references[i].first;
    Defect defect = make_defect(DefectCode::Corrupt);
    defect.detail = sentence("there is no vertex ", id, "");
    for (; i < references.size() && references[i].first == id; ++i) {
      const Index face = references[i].second;
      defect.faces.push_back(face);
      if (defect.positions.empty()) defect.positions = middle_of_face(soup, face);
    }
    defects.push_back(defect);
  }
}

void add_torn_lines(const Soup& soup, DefectList& defects) {
  for (const std::uint32_t line : soup.torn_lines) {
    Defect defect = make_defect(DefectCode::Corrupt);
    defect.line = line;
    defect.detail = sentence("line ", line, " is the remains of a torn record");
    defects.push_back(defect);
  }
}

}  // namespace

DefectList find_corrupt(const Soup& soup) {
  DefectList defects;
  add_positions(soup, defects);
  add_repeated_ids(soup, defects);
  add_missing_vertices(soup, defects);
  add_torn_lines(soup, defects);
  return defects;
}

}  // namespace meshalyzer
