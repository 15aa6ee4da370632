#include "meshalyzer/report/json/record_ids.h"

#include "meshalyzer/base/sort_unique.h"

#include <algorithm>

namespace meshalyzer {
namespace {

std::vector<EdgeList*> edge_lists(Offenders& all) {
  std::vector<EdgeList*> lists{&all.border_edges, &all.non_manifold_edges, &all.flipped_edges,
                               &all.indistinguishable_edges};
  for (std::optional<EdgeList>* list :
       {&all.short_edges, &all.long_edges, &all.small_angles, &all.large_angles}) {
    if (*list) {
      lists.push_back(&**list);
    }
  }
  return lists;
}

template <typename Visit>
void for_each_vertex(Analysis& analysis, const Visit& visit) {
  Offenders& all = analysis.offenders;
  for (std::vector<Index>* list :
       {&all.orphan_vertices, &all.duplicate_vertex_records, &all.non_manifold_vertices,
        &all.pinched_vertices, &all.indistinguishable_vertices}) {
    std::for_each(list->begin(), list->end(), visit);
  }
  for (EdgeList* list : edge_lists(all)) {
    for (std::array<Index, 2>& ends : list->ends) {
      visit(ends[0]);
      visit(ends[1]);
    }
  }
}

template <typename Visit>
void for_each_face(Analysis& analysis, const Visit& visit) {
  Offenders& all = analysis.offenders;
  for (std::vector<Index>* list :
       {&all.faces_with_missing_vertices, &all.degenerate_faces, &all.duplicate_face_records,
        &all.zero_area_faces, &all.duplicate_faces}) {
    std::for_each(list->begin(), list->end(), visit);
  }
  for (EdgeList* list : edge_lists(all)) {
    std::for_each(list->faces.begin(), list->faces.end(), visit);
  }
  if (all.large_aspect_ratios) {
    std::for_each(all.large_aspect_ratios->faces.begin(), all.large_aspect_ratios->faces.end(),
                  visit);
  }
  for (IntersectingPair& pair : all.intersecting_pairs) {
    visit(pair.face_a);
    visit(pair.face_b);
  }
  for (ComponentAnalysis& component : analysis.components) {
    visit(component.first_face);
  }
}

/// @param for_each  Calls a function with each member that holds an id.
/// @return The ids, each once, ascending; the members then hold the index of theirs.
template <typename ForEach>
std::vector<std::int32_t> replace_by_indices(const ForEach& for_each) {
  std::vector<std::int32_t> ids;
  for_each([&](const Index& place) { ids.push_back(static_cast<std::int32_t>(place)); });
  sort_unique(ids);
  ids.shrink_to_fit();
  for_each([&](Index& place) {
    const auto id = static_cast<std::int32_t>(place);
    place = static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  });
  return ids;
}

}  // namespace

void index_records(Analysis& analysis) {
  analysis.vertex_ids.named =
      replace_by_indices([&](const auto& visit) { for_each_vertex(analysis, visit); });
  analysis.face_ids.named =
      replace_by_indices([&](const auto& visit) { for_each_face(analysis, visit); });
}

}  // namespace meshalyzer
