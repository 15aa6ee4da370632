#include "meshalyzer/analysis/solids.h"

#include "meshalyzer/geometry/extent.h"
#include "meshalyzer/mesh/face_parts.h"
#include "meshalyzer/spatial/nesting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace meshalyzer {
namespace {

bool bounds_a_solid(const ComponentAnalysis& c) {
  return c.closed && c.manifold && c.consistent.value_or(false);
}

/// Leaves each pair of components once, ascending; it crosses if any did.
void merge_contacts(std::vector<PartContact>& contacts) {
  const auto key = [](const PartContact& c) { return std::tuple(c.a, c.b, !c.crosses); };
  std::sort(contacts.begin(), contacts.end(),
            [&](const PartContact& x, const PartContact& y) { return key(x) < key(y); });
  const auto same_parts = [](const PartContact& x, const PartContact& y) {
    return x.a == y.a && x.b == y.b;
  };
  contacts.erase(std::unique(contacts.begin(), contacts.end(), same_parts), contacts.end());
}

/// The pairs of components that intersect, each once, ascending.
std::vector<PartContact> find_contacts(const CutMesh& cut, const Components& components,
                                       std::span<const IntersectingPair> pairs) {
  std::vector<PartContact> contacts;
  // Merged now and then, so that memory follows the pairs of components, not those of faces.
  std::size_t enough = std::size_t{1} << 16;
  for (const IntersectingPair& pair : pairs) {
    const Index a = components.of_face[cut.side.mesh_face(pair.face_a)];
    const Index b = components.of_face[cut.side.mesh_face(pair.face_b)];
    if (a != b) {
      contacts.push_back({std::min(a, b), std::max(a, b), pair.kind == ContactKind::Crossing});
    }
    if (contacts.size() == enough) {
      merge_contacts(contacts);
      enough = std::max(enough, 2 * contacts.size());
    }
  }
  merge_contacts(contacts);
  return contacts;
}

/// The component of each face, but only of those that bound a solid.
std::vector<Index> solid_of_face(const Components& components,
                                 std::span<const ComponentAnalysis> analyses) {
  std::vector<Index> of_face(components.of_face);
  for (Index& c : of_face) {
    c = bounds_a_solid(analyses[c]) ? c : kNoIndex;
  }
  return of_face;
}

}  // namespace

void analyze_solids(const SolidsInput& input, std::vector<ComponentAnalysis>& analyses) {
  const Components& components = input.components;
  std::vector<std::uint8_t> is_closed(components.count);
  std::vector<Box3> boxes(components.count);
  for (std::size_t c = 0; c < components.count; ++c) {
    is_closed[c] = bounds_a_solid(analyses[c]) ? 1 : 0;
    boxes[c] = analyses[c].bounding_box;
  }
  const std::vector<Index> solids = solid_of_face(components, analyses);
  const std::vector<SignedVolume> volumes =
      signed_volumes(input.cut.mesh, {.of_face = solids, .count = components.count}, boxes);
  const std::vector<PartContact> contacts = find_contacts(input.cut, components, input.pairs);
  const Nesting nesting =
      find_nesting(input.tree, {.parts = {.of_face = components.of_face, .count = components.count},
                                .is_closed = is_closed,
                                .contacts = contacts});
  for (std::size_t c = 0; c < components.count; ++c) {
    if (nesting.inside[c] != kNoIndex) {
      analyses[c].inside = nesting.inside[c];
    }
    if (is_closed[c] != 0 && std::isfinite(volumes[c].value)) {
      analyses[c].volume = volumes[c].value;
    }
    if (is_closed[c] != 0 && volumes[c].sign != 0) {
      analyses[c].outward = (volumes[c].sign > 0) == (nesting.depth[c] % 2 == 0);
    }
  }
}

}  // namespace meshalyzer
