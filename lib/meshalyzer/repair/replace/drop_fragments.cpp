#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/repair/orient/internal/side_votes.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace meshalyzer {
namespace {

/// A fragment is small where it has at most this share of the area of the mesh.
constexpr double kSmallShare = 0.1;

/// What is known of each component.
struct SurfaceParts {
  Components components;
  std::vector<double> areas;
  std::vector<std::uint8_t> is_closed;
  std::vector<std::uint8_t> bounds;
};

SurfaceParts find_parts(const PreparedMesh& mesh) {
  SurfaceParts parts{
      .components = find_edge_components(mesh.cut()), .areas = {}, .is_closed = {}, .bounds = {}};
  const CutMesh& cut = mesh.cut();
  parts.areas.resize(parts.components.count);
  for (std::size_t f = 0; f < parts.components.of_face.size(); ++f) {
    const auto [a, b, c] = corners_of(mesh.soup(), cut.side.faces[f]);
    parts.areas[parts.components.of_face[f]] += accurate_normal(a, b, c).norm() / 2.0;
  }
  parts.is_closed = which_are_closed(cut, parts.components);
  parts.bounds = bounds_solid(mesh, parts.components);
  return parts;
}

}  // namespace

PassResult drop_fragments(const PassInput& input, Fragments which) {
  const SurfaceParts parts = find_parts(input.mesh);
  const std::size_t n = parts.components.count;
  const double total = std::accumulate(parts.areas.begin(), parts.areas.end(), 0.0);
  std::vector<std::uint8_t> is_dropped(n, 0);
  bool is_any_kept = false;
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_wanted = which == Fragments::All || parts.areas[i] <= kSmallShare * total;
    is_dropped[i] = parts.is_closed[i] == 0 && parts.bounds[i] == 0 && is_wanted ? 1 : 0;
    // Small sheets do not go for the sake of large ones that enclose nothing either, once these
    // had their chance to be closed.
    is_any_kept =
        is_any_kept || (which == Fragments::All ? parts.bounds[i] != 0 : is_dropped[i] == 0);
  }
  PassResult result;
  if (!is_any_kept) return result;
  const FacesByPart faces(parts.components.of_face, n);
  for (std::size_t i = 0; i < n; ++i) {
    if (is_dropped[i] == 0) continue;
    const Index op = result.edits.begin_operation();
    for (const Index f : faces.of(i)) {
      const Index face = input.mesh.cut().side.faces[f];
      result.edits.removed_faces.push_back({op, face});
      result.edits.interior_walls.push_back({op, corners_of(input.tracked.soup, face)});
    }
  }
  return result;
}

}  // namespace meshalyzer
