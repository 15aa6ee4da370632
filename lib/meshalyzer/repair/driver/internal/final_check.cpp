#include "meshalyzer/repair/driver/internal/final_check.h"

#include "meshalyzer/base/point_table.h"
#include "meshalyzer/repair/driver/internal/pairs_of_faces.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace meshalyzer {
namespace {

/// Prepares a mesh in which vertices at one position are one. Only the pairs of faces that have
/// other corners than before are searched, unless even the pairs before are not all known.
std::unique_ptr<const PreparedMesh> prepare_merged(const Soup& merged, const RepairState& state) {
  auto mesh = std::make_unique<PreparedMesh>(merged);
  const std::vector<Triangle>& before = state.tracked().soup.triangles;
  std::vector<Index> changed;
  for (Index face = 0; face < before.size(); ++face) {
    if (merged.triangles[face] != before[face]) changed.push_back(face);
  }
  std::vector<IntersectingPair> others = state.mesh().intersecting_pairs();
  if (state.mesh().was_intersection_search_cut()) return mesh;
  std::erase_if(others, [&](const IntersectingPair& pair) {
    return std::binary_search(changed.begin(), changed.end(), pair.face_a) ||
           std::binary_search(changed.begin(), changed.end(), pair.face_b);
  });
  mesh->set_intersecting_pairs(joined_pairs(find_pairs_of(*mesh, changed), others));
  return mesh;
}

}  // namespace

FinalCheck final_check_for(const RepairOptions& options, Format input) {
  const bool is_stl = options.written_as.value_or(input) == Format::Stl;
  return {
      .equal_points = is_stl ? EqualPoints::Merge : EqualPoints::Stay,
      .unwelded = options.contact == Contact::Keep ? UnweldedPairs::Ignore : UnweldedPairs::Count};
}

DefectInventory list_defective_in_file(const RepairState& state, const Tolerances& tolerances,
                                       const FinalCheck& check) {
  const TrackedMesh& tracked = state.tracked();
  if (check.equal_points == EqualPoints::Merge) {
    const std::vector<Index> first = first_equal_points(tracked.soup.positions);
    TrackedMesh merged = tracked;
    for (Triangle& triangle : merged.soup.triangles) {
      for (Index& v : triangle) v = v == kNoIndex ? kNoIndex : first[v];
    }
    if (merged.soup.triangles != tracked.soup.triangles) {
      return list_defective(merged, *prepare_merged(merged.soup, state), tolerances,
                            check.unwelded);
    }
  }
  return list_defective(tracked, state.mesh(), tolerances, check.unwelded);
}

bool is_good_in_file(const RepairState& state, const Tolerances& tolerances,
                     const FinalCheck& check) {
  const DefectInventory found = list_defective_in_file(state, tolerances, check);
  const auto yes = [&](Attribute attribute) {
    return found.is_yes[static_cast<std::size_t>(attribute)];
  };
  return yes(Attribute::Closed) && yes(Attribute::Manifold) && yes(Attribute::Consistent) &&
         yes(Attribute::Outward) &&
         std::all_of(found.counts.begin(), found.counts.end(), [](auto n) { return n == 0; });
}

}  // namespace meshalyzer
