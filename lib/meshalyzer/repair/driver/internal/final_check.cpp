#include "meshalyzer/repair/driver/internal/final_check.h"

#include "meshalyzer/repair/driver/internal/pairs_of_faces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

namespace meshalyzer {
namespace {

std::array<std::uint64_t, 3> bits_of(const Vec3& p) {
  return {std::bit_cast<std::uint64_t>(p[0]), std::bit_cast<std::uint64_t>(p[1]),
          std::bit_cast<std::uint64_t>(p[2])};
}

/// Returns for each vertex the lowest one with bit-identical coordinates.
std::vector<Index> find_representatives(const std::vector<Vec3>& positions) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::pair(bits_of(positions[a]), a) < std::pair(bits_of(positions[b]), b);
  });
  std::vector<Index> representative(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && bits_of(positions[order[i]]) == bits_of(positions[order[i - 1]]);
    representative[order[i]] = repeats ? representative[order[i - 1]] : order[i];
  }
  return representative;
}

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
    const std::vector<Index> representative = find_representatives(tracked.soup.positions);
    TrackedMesh merged = tracked;
    for (Triangle& triangle : merged.soup.triangles) {
      for (Index& v : triangle) v = v == kNoIndex ? kNoIndex : representative[v];
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
