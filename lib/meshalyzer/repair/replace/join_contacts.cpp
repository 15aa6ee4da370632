#include "meshalyzer/repair/cut/internal/cut_edits.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/join_points.h"
#include "meshalyzer/repair/replace/internal/mesh_operands.h"
#include "meshalyzer/repair/split/internal/contact_places.h"
#include "meshalyzer/spatial/oblique_direction.h"
#include "meshalyzer/topology/border.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The thickness of the rods, as shares of the maximum deviation: thinner ones are tried where
/// thicker ones cannot be united with the mesh.
constexpr std::array<double, 3> kThicknessesOfRods{1.0 / 16.0, 1.0 / 256.0, 1.0 / 4096.0};
/// Rounding may take this share of the thickness.
constexpr double kRoundingOfRods = 0.01;
/// Where more pairs of faces touch, or meet a rod, rounding makes faces intersect again and again,
/// and each thickness would be tried in vain for ten seconds and more.
constexpr std::size_t kMostPairsJoined = 50'000;

using Segments = std::vector<std::array<Vec3, 2>>;

std::array<Index, 2> ascending(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Tells whether a mesh is closed, and its faces only touch at copies of vertices.
bool has_contacts_only(const PreparedMesh& mesh) {
  const auto& pairs = mesh.intersecting_pairs();
  return !pairs.empty() && !mesh.was_intersection_search_cut() &&
         std::all_of(pairs.begin(), pairs.end(),
                     [](const auto& pair) { return pair.kind == ContactKind::Unwelded; }) &&
         find_border_edges(mesh.cut()).empty();
}

/// Finds the segments along which faces touch; those of single points have no length.
Segments contact_segments(const Soup& soup, const ContactPlaces& contacts) {
  // One vertex stands for all at its place.
  std::map<Index, Index> first_of;
  for (const ContactPlace& place : contacts.places) {
    for (const auto& unit : place.units) {
      for (const Index v : unit) first_of[v] = place.units.front().front();
    }
  }
  const auto first_at = [&](Index v) {
    const auto found = first_of.find(v);
    return found == first_of.end() ? v : found->second;
  };
  // The edges between two places; where there are several, faces touch along all of them. They may
  // have an end in common.
  std::map<std::array<Index, 2>, std::set<std::array<Index, 2>>> edges;
  for (const auto& [v, first] : first_of) {
    for (const Index face : contacts.incident.faces(contacts.incident.entry_of(v))) {
      for (const Index w : soup.triangles[face]) {
        const Index other = first_at(w);
        if (other == first) continue;
        edges[ascending(first, other)].insert(ascending(v, w));
      }
    }
  }
  Segments segments;
  std::set<Index> with_segment;
  for (const auto& [ends, of_ends] : edges) {
    if (of_ends.size() < 2) continue;
    segments.push_back({soup.positions[ends[0]], soup.positions[ends[1]]});
    with_segment.insert(ends.begin(), ends.end());
  }
  for (const ContactPlace& place : contacts.places) {
    const Index first = place.units.front().front();
    const Vec3& p = soup.positions[first];
    if (!with_segment.contains(first)) segments.push_back({p, p});
  }
  return segments;
}

/// The operand of all rods.
constexpr Index kRods = 1;

/// Adds a rod with three sides round a segment, and beyond its ends.
void add_rod(const std::array<Vec3, 2>& segment, double thickness, MeshOperands& operands) {
  const Vec3 along = segment[1] == segment[0] ? kObliqueDirection
                                              : Vec3((segment[1] - segment[0]).stableNormalized());
  const Vec3 x = along.unitOrthogonal();
  const Vec3 y = along.cross(x);
  // A triangle round the segment, in multiples of the thickness. Its ends are askew.
  static constexpr std::array<std::array<double, 3>, 3> kCorners{
      {{1.0, 0.1, 0.8}, {-0.6, 0.8, 1.0}, {-0.4, -0.9, 0.6}}};
  std::vector<Vec3> positions;
  for (const auto& [u, v, w] : kCorners) {
    const Vec3 across = thickness * (u * x + v * y);
    positions.emplace_back(segment[0] + across - thickness * w * along);
    positions.emplace_back(segment[1] + across + thickness * w * along);
  }
  static constexpr std::array<Triangle, 8> kFaces{
      {{0, 4, 2}, {1, 3, 5}, {0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}, {4, 0, 1}, {4, 1, 5}}};
  operands.add_solid(positions, kFaces, kRods);
}

/// Returns a mesh, and rods along segments.
MeshOperands mesh_with_rods(const Soup& mesh, const Segments& segments, double thickness) {
  MeshOperands operands(mesh);
  for (Index face = 0; face < mesh.n_faces(); ++face) {
    if (is_in_complex(mesh.triangles[face])) operands.add_face(mesh.triangles[face], face);
  }
  for (const auto& segment : segments) add_rod(segment, thickness, operands);
  return operands;
}

/// Unites a mesh with rods along segments, the first time with thick ones.
PassResult unite_with_rods(const PassInput& input, const Segments& segments) {
  // Where a thick rod was rejected, as one that goes too far, a thinner one is tried.
  const std::size_t n_skipped = input.operation_size == OperationSize::Normal ? 0 : 1;
  for (std::size_t i = n_skipped; i < kThicknessesOfRods.size() && !input.wants_to_stop(); ++i) {
    const double thickness = kThicknessesOfRods.at(i) * input.limits.max_deviation;
    const MeshOperands operands = mesh_with_rods(input.tracked.soup, segments, thickness);
    const InsideRule rule = [](std::span<const int> windings) {
      return windings[MeshOperands::kMesh] != 0 || windings[kRods] >= 1;
    };
    const CombinedSolid solid = operands.combine(2, rule,
                                                 {.max_deviation = kRoundingOfRods * thickness,
                                                  .max_pairs = kMostPairsJoined,
                                                  .wants_to_stop = input.wants_to_stop});
    if (solid.outcome == CombineOutcome::TooManyPairs) break;
    if (solid.outcome != CombineOutcome::Done) continue;
    PassResult result = cut_edits(input, {}, operands.surface_of(solid, input));
    result.has_smaller_operations = n_skipped == 0;
    return result;
  }
  return {};
}

/// Tells whether rods may be added to a mesh.
bool may_join(const PassInput& input) {
  return input.limits.max_deviation > 0.0 && input.limits.groups != Groups::Faces;
}

}  // namespace

PassResult join_contacts(const PassInput& input) {
  if (!may_join(input) || !has_contacts_only(input.mesh)) return {};
  return unite_with_rods(
      input, contact_segments(input.tracked.soup, find_contact_places(input.tracked, input.mesh)));
}

std::vector<Vec3> contact_points(const TrackedMesh& tracked, const PreparedMesh& mesh) {
  std::vector<Vec3> points;
  if (!has_contacts_only(mesh)) return points;
  for (const ContactPlace& place : find_contact_places(tracked, mesh).places) {
    points.push_back(mesh.soup().positions[place.units.front().front()]);
  }
  return points;
}

PassResult join_at_points(const PassInput& input, std::span<const Vec3> points) {
  if (!may_join(input) || points.empty()) return {};
  Segments segments;
  for (const Vec3& point : points) segments.push_back({point, point});
  return unite_with_rods(input, segments);
}

}  // namespace meshalyzer
