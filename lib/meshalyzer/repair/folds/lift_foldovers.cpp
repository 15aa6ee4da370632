#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/step_contacts.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/rules/internal/contact_rule.h"
#include "meshalyzer/topology/border.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The distances by which a vertex is lifted, as multiples of the height tolerance.
constexpr std::array<double, 3> kHeights{1.25, 2.5, 4.0};
/// A foldover with more vertices, or with more faces round it, is left, because each of its
/// vertices is tried.
constexpr std::size_t kMostVertices = 16;
constexpr std::size_t kMostFacesAround = 500;

/// The defects of a part of a mesh that lifting is to remove, or must not make.
struct LocalDefects {
  std::size_t n_foldovers = 0;
  std::size_t n_thin = 0;
};

/// Lifts foldovers of a mesh one by one, as long as they are far enough from each other.
class FoldoverLifter {
 public:
  explicit FoldoverLifter(const PassInput& input)
      : input_(input),
        soup_(input.tracked.soup),
        mesh_(soup_, {}, input.tolerances.degeneracy),
        is_used_(soup_.n_faces(), 0) {}

  void treat(const Defect& foldover) {
    const std::vector<Index> vertices = vertices_of(foldover.faces);
    if (vertices.size() > kMostVertices) return;
    const std::vector<Index> around = faces_around(vertices);
    const bool is_taken =
        std::any_of(around.begin(), around.end(), [&](Index f) { return is_used_[f] != 0; });
    if (is_taken || around.size() > kMostFacesAround) return;
    const std::optional<MendStep::Move> move = find_move(foldover, vertices, around);
    if (!move) return;
    for (const Index f : around) is_used_[f] = 1;
    const Index op = edits_.begin_operation();
    edits_.moved_vertices.push_back({op, move->vertex, move->to});
  }

  [[nodiscard]] Edits take() { return std::move(edits_); }

 private:
  /// Returns the vertices of some faces, ascending.
  [[nodiscard]] std::vector<Index> vertices_of(const std::vector<Index>& faces) const {
    std::vector<Index> vertices;
    for (const Index f : faces) {
      const Triangle& t = mesh_.triangle(f);
      vertices.insert(vertices.end(), t.begin(), t.end());
    }
    sort_unique(vertices);
    return vertices;
  }

  /// Returns the faces at some vertices, and those at the vertices of these, ascending.
  [[nodiscard]] std::vector<Index> faces_around(std::vector<Index> vertices) const {
    std::vector<Index> faces;
    for (int ring = 0; ring < 2 && faces.size() <= kMostFacesAround; ++ring) {
      for (const Index v : vertices) {
        const auto at_vertex = mesh_.faces_at(v);
        faces.insert(faces.end(), at_vertex.begin(), at_vertex.end());
      }
      sort_unique(faces);
      vertices = vertices_of(faces);
    }
    return faces;
  }

  [[nodiscard]] std::optional<MendStep::Move> find_move(const Defect& foldover,
                                                        const std::vector<Index>& vertices,
                                                        const std::vector<Index>& around) const {
    const LocalDefects before = defects_of(around, {});
    const std::optional<Vec3> normal = normal_of_largest(foldover.faces);
    if (before.n_foldovers == 0 || !normal) return std::nullopt;
    for (const double height : kHeights) {
      const double distance = height * input_.tolerances.height;
      if (!(distance <= input_.limits.max_deviation)) return std::nullopt;
      for (const Index v : vertices) {
        if (rules_.is_fixed(mesh_, v)) continue;
        for (const double sense : {1.0, -1.0}) {
          MendStep step;
          step.moved = {v, mesh_.position(v) + sense * distance * *normal};
          if (meets_face(*step.moved, around)) continue;
          const LocalDefects after = defects_of(around, step);
          if (after.n_foldovers < before.n_foldovers && after.n_thin <= before.n_thin &&
              !contacts_.are_made_by(step)) {
            return step.moved;
          }
        }
      }
    }
    return std::nullopt;
  }

  /// Tells whether a vertex meets one of some faces on its way: what lies between its own faces and
  /// that one would be turned inside out.
  [[nodiscard]] bool meets_face(const MendStep::Move& move, const std::vector<Index>& faces) const {
    const PlacedFace way{{move.vertex, kNoIndex, kNoIndex},
                         {mesh_.position(move.vertex), move.to, move.to}};
    return std::any_of(faces.begin(), faces.end(), [&](Index f) {
      const Triangle& t = mesh_.triangle(f);
      return !has_corner(t, move.vertex) && are_in_contact({t, mesh_.corners(t)}, way);
    });
  }

  /// Returns the unit normal of the largest of some faces; nothing if none has any.
  [[nodiscard]] std::optional<Vec3> normal_of_largest(const std::vector<Index>& faces) const {
    Vec3 largest = Vec3::Zero();
    for (const Index f : faces) {
      const auto [a, b, c] = corners_of(soup_, f);
      const Vec3 normal = accurate_normal(a, b, c);
      if (normal.stableNorm() > largest.stableNorm()) largest = normal;
    }
    const Vec3 unit = largest.stableNormalized();
    return unit.allFinite() && !unit.isZero(0) ? std::optional(unit) : std::nullopt;
  }

  /// Counts the defects of some faces by themselves, after a step.
  [[nodiscard]] LocalDefects defects_of(const std::vector<Index>& faces,
                                        const MendStep& step) const {
    const Soup part = part_after(faces, step);
    const PreparedMesh prepared(part);
    return {find_foldovers(prepared, input_.tolerances).size(),
            find_thin_facets(prepared, input_.tolerances).size()};
  }

  /// Returns some faces as a mesh of their own, after a step.
  [[nodiscard]] Soup part_after(const std::vector<Index>& faces, const MendStep& step) const {
    const std::vector<Index> vertices = vertices_of(faces);
    Soup part;
    for (const Index v : vertices) {
      part.positions.push_back(step.moved && step.moved->vertex == v ? step.moved->to
                                                                     : mesh_.position(v));
    }
    for (const Index f : faces) {
      Triangle t = mesh_.triangle(f);
      for (Index& v : t) {
        v = static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                               vertices.begin());
      }
      part.triangles.push_back(t);
    }
    return part;
  }

  const PassInput& input_;
  const Soup& soup_;
  WorkingMesh mesh_;
  StepContacts contacts_{input_.mesh, mesh_};
  MendRules rules_{input_};
  /// Non-zero for each face that an operation relies on.
  std::vector<std::uint8_t> is_used_;
  Edits edits_;
};

}  // namespace

PassResult lift_foldovers(const PassInput& input) {
  PassResult result;
  if (!find_border_edges(input.mesh.cut()).empty()) return result;
  const DefectList foldovers = find_foldovers(input.mesh, input.tolerances, input.wants_to_stop);
  if (foldovers.empty()) return result;
  FoldoverLifter lifter(input);
  for (const Defect& foldover : foldovers) {
    if (input.wants_to_stop()) break;
    lifter.treat(foldover);
  }
  result.edits = lifter.take();
  return result;
}

}  // namespace meshalyzer
