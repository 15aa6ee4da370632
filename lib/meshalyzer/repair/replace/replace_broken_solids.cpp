#include "meshalyzer/base/triangle.h"
#include "meshalyzer/contour/contour_mesh.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"
#include "meshalyzer/repair/replace/internal/replacements.h"
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

/// Proposes to put a contour in the place of a broken solid.
class Replacing {
 public:
  Replacing(const Soup& all, const BrokenSolid& solid, Edits& edits)
      : solid_(solid),
        edits_(edits),
        old_(soup_of(all, solid)),
        n_vertices_(static_cast<Index>(all.n_vertices() + edits.added_vertices.size())),
        cut_(build(old_)),
        tree_(cut_),
        closest_(tree_) {}

  [[nodiscard]] std::optional<ContouredMesh> contour(const ContourLimits& limits) const {
    return contour_mesh(old_, limits);
  }

  void propose(const ContouredMesh& made) {
    const Index op = edits_.begin_operation();
    for (const Index face : solid_.faces) edits_.removed_faces.push_back({op, face});
    for (const Vec3& p : made.soup.positions) edits_.added_vertices.push_back({op, p});
    // The wall of a cavity points inwards, and so must its replacement.
    const bool is_turned = six_volumes(old_) < 0.0;
    for (Index face = 0; face < made.soup.n_faces(); ++face) {
      Triangle t = made.soup.triangles[face];
      if (is_turned) std::swap(t[1], t[2]);
      for (Index& corner : t) corner += n_vertices_;
      edits_.added_faces.push_back({op, t, nearest(corners_of(made.soup, face))});
    }
    for (const auto& wall : made.walls) edits_.interior_walls.push_back({op, {wall}});
  }

 private:
  /// Returns the face of the whole mesh that is nearest to the middle of a new one.
  [[nodiscard]] Index nearest(const Corners& t) {
    const auto found = closest_.find({.point = centroid_of(t), .hint = hint_});
    if (!found) return solid_.faces.front();
    hint_ = found->slot;
    return solid_.faces[cut_.side.faces[found->mesh_face]];
  }

  const BrokenSolid& solid_;
  Edits& edits_;
  Soup old_;
  Index n_vertices_;
  CutMesh cut_;
  FaceTree tree_;
  ClosestPoints closest_;
  Index hint_ = kNoIndex;
};

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
    Replacing replacing(input.tracked.soup, solid, replacement.result.edits);
    const auto made = replacing.contour({.max_deviation = options.max_deviation,
                                         .max_tetrahedra = std::min(kMaxTetrahedra, n_left),
                                         .wants_to_stop = input.wants_to_stop});
    if (!made || !made->is_within) {
      return refuse(solid, "no replacement within the maximum deviation was found",
                    made.has_value());
    }
    if (made->soup.triangles.empty()) {
      return refuse(solid, "it encloses nothing that a replacement could bound");
    }
    replacing.propose(*made);
    replacement.deviation = std::max(replacement.deviation, made->deviation);
    n_left -= std::min(n_left, made->n_tetrahedra);
  }
  return replacement;
}

}  // namespace meshalyzer
