#include "meshalyzer/contour/contour_mesh.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"
#include "meshalyzer/spatial/closest_point.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Where the contour may not be as far away as all repairs together, so that those before it have
/// room: shares of the maximum deviation, for the first attempt and for the second.
constexpr double kShare = 0.9;
constexpr double kSmallShare = 0.4;

/// The faces of a broken solid alone.
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
class Replacement {
 public:
  Replacement(const Soup& all, const BrokenSolid& solid, Edits& edits)
      : solid_(solid),
        edits_(edits),
        old_(soup_of(all, solid)),
        n_vertices_(static_cast<Index>(all.n_vertices() + edits.added_vertices.size())),
        cut_(build(old_)),
        tree_(cut_),
        closest_(tree_) {}

  [[nodiscard]] std::optional<ContouredMesh> contour(double max_deviation) const {
    return contour_mesh(old_, {.max_deviation = max_deviation});
  }

  void propose(const ContouredMesh& made) {
    const Index op = edits_.begin_operation();
    for (const Index face : solid_.faces) edits_.removed_faces.push_back({op, face});
    for (const Vec3& p : made.soup.positions) edits_.added_vertices.push_back({op, p});
    // The wall of a cavity points inwards, and so does what replaces it.
    const bool is_turned = six_volumes(old_) < 0.0;
    for (Index face = 0; face < made.soup.n_faces(); ++face) {
      Triangle t = made.soup.triangles[face];
      if (is_turned) std::swap(t[1], t[2]);
      for (Index& corner : t) corner += n_vertices_;
      edits_.added_faces.push_back({op, t, nearest(corners_of(made.soup, face))});
    }
    for (const auto& wall : made.walls) edits_.interior_walls.push_back({op, wall});
  }

 private:
  /// The face of the whole mesh that is nearest to the middle of a new one.
  [[nodiscard]] Index nearest(const std::array<Vec3, 3>& t) {
    const auto found = closest_.find({.point = (t[0] + t[1] + t[2]) / 3.0, .hint = hint_});
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

}  // namespace

PassResult replace_broken_solids(const PassInput& input) {
  PassResult result;
  const double share = input.operation_size == OperationSize::Normal ? kShare : kSmallShare;
  const double max_deviation = share * input.limits.max_deviation;
  for (const BrokenSolid& solid : find_broken_solids(input.mesh)) {
    const auto refuse = [&](const char* reason) {
      result.refused.push_back(
          {.code = DefectCode::SelfIntersection, .face = solid.faces.front(), .reason = reason});
    };
    if (!solid.bounds_solid) {
      refuse("a part of it bounds no solid, which a replacement would drop");
      continue;
    }
    if (!(max_deviation > 0.0)) {
      refuse("a replacement needs a maximum deviation above 0");
      continue;
    }
    Replacement replacement(input.tracked.soup, solid, result.edits);
    const auto made = replacement.contour(max_deviation);
    if (!made || !made->is_within) {
      refuse("no replacement within the maximum deviation was found");
    } else {
      replacement.propose(*made);
    }
  }
  return result;
}

}  // namespace meshalyzer
