#include "meshalyzer/base/triangle.h"
#include "meshalyzer/contour/contour_mesh.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"
#include "meshalyzer/repair/replace/internal/new_surface.h"
#include "meshalyzer/repair/replace/internal/replacements.h"
#include "meshalyzer/repair/replace/internal/usable_contour.h"
#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Replacements with a larger grid are not made, because they would take more than some seconds;
/// nor are those of all solids together.
constexpr std::size_t kMaxTetrahedra = 500'000;
constexpr std::size_t kMaxTetrahedraOfAll = 1'000'000;

/// Returns the faces of a broken solid alone.
Soup soup_of(const Soup& all, const BrokenSolid& solid) {
  Soup soup;
  soup.positions = all.positions;
  soup.triangles.reserve(solid.faces.size());
  for (const Index face : solid.faces) soup.triangles.push_back(all.triangles[face]);
  return soup;
}

double six_volumes(const Soup& soup) {
  double sum = 0.0;
  if (soup.triangles.empty()) return sum;
  const Vec3 origin = soup.positions[soup.triangles.front()[0]];
  for (Index face = 0; face < soup.n_faces(); ++face) {
    const auto [a, b, c] = corners_of(soup, face);
    sum += (a - origin).dot((b - origin).cross(c - origin));
  }
  return sum;
}

/// Returns a contour of a broken solid as what takes its place.
///
/// @param old  The faces of the solid alone.
NewSurface surface_of(const ContouredMesh& made, const Soup& old, const BrokenSolid& solid) {
  NewSurface surface{
      .positions = made.soup.positions, .triangles = made.soup.triangles, .origins = {}};
  // The wall of a cavity points inwards, and so must its replacement.
  if (six_volumes(old) < 0.0) {
    for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  }
  const CutMesh cut = build(old);
  const FaceTree tree(cut);
  const ClosestPoints closest(tree);
  Index hint = kNoIndex;
  for (Index face = 0; face < made.soup.n_faces(); ++face) {
    const auto found =
        closest.find({.point = centroid_of(corners_of(made.soup, face)), .hint = hint});
    if (found) hint = found->slot;
    surface.origins.push_back(found ? solid.faces[cut.side.faces[found->mesh_face]]
                                    : solid.faces.front());
  }
  return surface;
}

std::vector<BrokenSolid> solids_to_replace(const PreparedMesh& mesh, ReplaceOptions::Scope scope) {
  if (scope == ReplaceOptions::Scope::Broken) return find_broken_solids(mesh);
  BrokenSolid whole = whole_mesh_as_solid(mesh);
  if (whole.faces.empty()) return {};
  return {std::move(whole)};
}

/// The reason why a solid is not replaced; null if it may be.
const char* reason_against(const BrokenSolid& solid, const ReplaceOptions& options) {
  if (!solid.any_bounds_solid) return "it bounds no solid: it is a sheet";
  if (!solid.all_bound_solid && options.sheets == ReplaceOptions::Sheets::Kept) {
    return "a part of it bounds no solid, which a replacement would drop";
  }
  if (!(options.max_deviation > 0.0)) return "no deviation is left for a replacement";
  return nullptr;
}

/// Proposes nothing: what is not good as a whole is not kept.
Replacement refuse(const BrokenSolid& solid, const char* reason, bool needs_larger_grid = false) {
  Replacement replacement;
  replacement.result.refused.push_back(
      {.code = DefectCode::SelfIntersection, .face = solid.faces.front(), .reason = reason});
  replacement.needs_larger_grid = needs_larger_grid;
  return replacement;
}

}  // namespace

Replacement replace_broken_solids(const PassInput& input, const ReplaceOptions& options) {
  const std::vector<BrokenSolid> solids = solids_to_replace(input.mesh, options.scope);
  for (const BrokenSolid& solid : solids) {
    if (const char* reason = reason_against(solid, options)) return refuse(solid, reason);
  }
  Replacement replacement;
  std::size_t n_left = kMaxTetrahedraOfAll;
  for (const BrokenSolid& solid : solids) {
    const Soup old = soup_of(input.tracked.soup, solid);
    const auto made = contour_mesh(old, {.max_deviation = options.max_deviation,
                                         .max_tetrahedra = std::min(kMaxTetrahedra, n_left),
                                         .wants_to_stop = input.wants_to_stop});
    if (const char* reason = reason_against(made, input.wants_to_stop)) {
      return refuse(solid, reason, made.has_value());
    }
    if (made->soup.triangles.empty()) {
      return refuse(solid, "it encloses nothing that a replacement could bound");
    }
    Edits& edits = replacement.result.edits;
    const Index op =
        replace_faces(input.tracked.soup, solid.faces, surface_of(*made, old, solid), edits);
    for (const Corners& wall : made->walls) edits.interior_walls.push_back({op, {wall}});
    replacement.deviation = std::max(replacement.deviation, made->deviation);
    n_left -= std::min(n_left, made->n_tetrahedra);
  }
  return replacement;
}

}  // namespace meshalyzer
