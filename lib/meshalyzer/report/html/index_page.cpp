#include "meshalyzer/report/html/index_table.h"
#include "meshalyzer/report/html/page.h"
#include "meshalyzer/report/html/page_frame.h"
#include "meshalyzer/report/html/set_notes.h"
#include "meshalyzer/report/html/set_sections.h"
#include "meshalyzer/report/text/short_list.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

std::size_t count_if_row(const std::vector<IndexRow>& rows, RowState state) {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](const IndexRow& row) { return state_of(row) == state; }));
}

/// Appends what is wrong between the meshes.
void append_reasons(std::vector<std::string>& reasons, const SetIntersections& found) {
  const auto append = [&](std::size_t n, std::string_view one, std::string_view many) {
    if (n != 0) reasons.push_back(counted(n, one, many));
  };
  append(found.pairs.size(), "pair of faces of different meshes intersects",
         "pairs of faces of different meshes intersect");
  append(found.contained.size(), "mesh is inside another one", "meshes are inside another one");
  append(found.partly_contained.size(), "mesh is partly inside another one",
         "meshes are partly inside another one");
}

Verdict verdict_of(const std::vector<IndexRow>& rows, const SetAnalysis* set) {
  const std::size_t not_good = count_if_row(rows, RowState::NotGood);
  const std::size_t unreadable = count_if_row(rows, RowState::Unreadable);
  Verdict verdict{Verdict::Kind::Bad, "Not good"};
  if (not_good != 0) {
    verdict.reasons.push_back(counted(not_good, "mesh is not good", "meshes are not good"));
  }
  if (unreadable != 0) {
    verdict.reasons.push_back(counted(unreadable, "file cannot be read", "files cannot be read"));
  }
  if (set != nullptr && set->intersections) append_reasons(verdict.reasons, *set->intersections);
  if (!verdict.reasons.empty()) return verdict;
  if (count_if_row(rows, RowState::Good) == 0) return {};
  return {Verdict::Kind::Good, "Good"};
}

std::string facts_of(const std::vector<IndexRow>& rows) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const IndexRow& row : rows) {
    vertices += row.vertices;
    faces += row.faces;
  }
  std::string facts = counted(rows.size(), "mesh", "meshes");
  facts += ", ";
  facts += counted(faces, "face", "faces");
  facts += ", ";
  facts += counted(vertices, "vertex", "vertices");
  return facts;
}

}  // namespace

IndexRow index_row(const Analysis& analysis, const DefectReport& defects, std::string name,
                   std::string page) {
  IndexRow row{.name = std::move(name), .page = std::move(page)};
  const std::optional<Goodness>& goodness =
      analysis.goodness ? analysis.goodness : analysis.fitness;
  if (goodness) {
    row.good = goodness->good;
    row.reasons = goodness->reasons;
  }
  row.vertices = analysis.characteristics.vertices;
  row.faces = analysis.characteristics.faces;
  if (analysis.has_characteristics) {
    row.area = analysis.characteristics.area;
    row.volume = analysis.characteristics.volume.value;
  }
  row.defects = defects.counts;
  return row;
}

std::string html_index(const std::vector<IndexRow>& rows, const SetAnalysis* set) {
  const PageHeader header{
      .name = "All meshes", .verdict = verdict_of(rows, set), .facts = facts_of(rows)};
  return html_page(header, {}, [&](HtmlWriter& html) {
    append_meshes_section(
        html, rows, set == nullptr ? std::vector<std::vector<std::string>>{} : set_notes(*set));
    if (set != nullptr) append_set_sections(html, *set);
  });
}

}  // namespace meshalyzer
