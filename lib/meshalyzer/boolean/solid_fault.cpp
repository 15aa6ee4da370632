#include "meshalyzer/boolean/solid_fault.h"

#include "meshalyzer/base/runs.h"
#include "meshalyzer/geometry/volume.h"
#include "meshalyzer/mesh/edge_key.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/mesh/require_records.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The edges that are not crossed equally often in both directions.
struct UnevenEdges {
  /// The edges with one face.
  std::size_t n_borders = 0;
  std::size_t n_others = 0;
};

UnevenEdges count_uneven_edges(const Soup& soup) {
  // Each entry has the key of the edge, and the direction.
  using Side = std::pair<std::uint64_t, int>;
  std::vector<Side> sides;
  sides.reserve(3 * soup.n_faces());
  for (const Triangle& t : soup.triangles) {
    if (!is_in_complex(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = t[k];
      const Index to = t[(k + 1) % 3];
      sides.emplace_back(edge_key(from, to), from <= to ? 1 : -1);
    }
  }
  std::sort(sides.begin(), sides.end());
  UnevenEdges edges;
  for_each_run(std::span(sides), &Side::first, [&](std::span<const Side> edge) {
    int sum = 0;
    for (const Side& side : edge) sum += side.second;
    if (sum != 0) ++(edge.size() == 1 ? edges.n_borders : edges.n_others);
  });
  return edges;
}

std::string counted_edges(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + (n == 1 ? one : many);
}

std::string fault_of_edges(const UnevenEdges& edges) {
  if (edges.n_borders != 0) {
    return "it is not closed: " +
           counted_edges(edges.n_borders, " edge has one face only", " edges have one face only");
  }
  if (edges.n_others != 0) {
    return "its faces are not oriented alike: " +
           counted_edges(edges.n_others, " edge is", " edges are") +
           " crossed more often in one direction than in the other";
  }
  return {};
}

/// Tells whether a closed component that is no shell encloses nothing.
bool encloses_nothing(const PreparedMesh& mesh) {
  const Components& components = mesh.components();
  const std::vector<SignedVolume> volumes = signed_volumes(
      mesh.cut().mesh, {components.of_face, components.count}, mesh.component_boxes());
  return std::none_of(volumes.begin(), volumes.end(),
                      [](const SignedVolume& volume) { return volume.sign > 0; });
}

/// Returns 1 for each component that intersects another one, else 0.
std::vector<std::uint8_t> which_meet_others(const PreparedMesh& mesh) {
  const Components& components = mesh.components();
  const auto of = [&](Index face) { return components.of_face[mesh.cut().side.mesh_face(face)]; };
  std::vector<std::uint8_t> meets(components.count, 0);
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    if (of(pair.face_a) != of(pair.face_b)) meets[of(pair.face_a)] = meets[of(pair.face_b)] = 1;
  }
  return meets;
}

/// Tells whether a shell is inside out. A shell that crosses others subtracts from what they
/// enclose and is not.
bool has_inward_shell(const PreparedMesh& mesh) {
  const std::vector<Shell>& shells = mesh.shells();
  const auto is_inward = [](const Shell& shell) { return shell.outward == false; };
  if (std::none_of(shells.begin(), shells.end(), is_inward)) return false;
  const std::vector<std::uint8_t> meets = which_meet_others(mesh);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (is_inward(shells[i]) && meets[i] == 0) return true;
  }
  return false;
}

std::string fault_of_shells(const Soup& soup) {
  const PreparedMesh mesh(soup);
  if (has_inward_shell(mesh)) {
    return mesh.shells().size() == 1 ? "it is inside out" : "one of its components is inside out";
  }
  return encloses_nothing(mesh) ? "it encloses nothing, or is inside out" : "";
}

}  // namespace

std::string find_solid_fault(const Soup& soup) {
  require_records(soup);
  if (!has_finite_positions(soup)) return "it has a position that is not finite";
  if (soup.triangles.empty()) return "it has no faces";
  if (!soup.missing.empty()) return "its faces name vertices that are not there";
  const std::string fault = fault_of_edges(count_uneven_edges(soup));
  return fault.empty() ? fault_of_shells(soup) : fault;
}

}  // namespace meshalyzer
