#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/facets/internal/collapse_edge.h"
#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/retract_cap.h"
#include "meshalyzer/repair/facets/internal/step_journal.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// An edge component of which every face is thin, so that no surface could take its place.
struct FlatComponents {
  /// Their faces, ascending.
  std::vector<Index> faces;
  /// The faces of those components whose corners are all within the maximum deviation of the rest
  /// of the mesh, so that the surface loses nothing without them. Each list is ascending.
  std::vector<std::vector<Index>> needless;
};

/// Returns the number of faces of each component that are not thin.
std::vector<Index> count_others(const Components& components, const SideTable& side,
                                std::span<const Index> thin_faces) {
  std::vector<Index> n_others(components.count, 0);
  for (const Index component : components.of_face) ++n_others[component];
  for (const Index f : thin_faces) --n_others[components.of_face[side.mesh_face(f)]];
  return n_others;
}

/// Returns the positions of the vertices of some faces.
std::vector<Vec3> places_of(const Soup& soup, const std::vector<Index>& faces) {
  std::vector<Vec3> places;
  for (const Index f : faces) {
    for (const Index v : soup.triangles[f]) places.push_back(soup.positions[v]);
  }
  return places;
}

/// Returns the faces of the complex that are not among some others.
///
/// @param without  Ascending.
std::vector<Index> mesh_faces_without(const SideTable& side, const std::vector<Index>& without) {
  std::vector<Index> others;
  for (Index f = 0; f < side.faces.size(); ++f) {
    if (!std::binary_search(without.begin(), without.end(), side.faces[f])) others.push_back(f);
  }
  return others;
}

/// Tells which faces are near to the rest of the mesh. It has a tree of its own: in that of all
/// faces, each search would visit all that are left out, and these may be nearly all.
class RestOfMesh {
 public:
  /// @param without  The faces that are left out, ascending.
  RestOfMesh(const PassInput& input, const std::vector<Index>& without)
      : tree_(input.mesh.cut(), mesh_faces_without(input.mesh.cut().side, without)),
        within_(input.limits.max_deviation) {}

  [[nodiscard]] bool are_near(const std::vector<Vec3>& places) const {
    return std::all_of(places.begin(), places.end(), [&](const Vec3& p) {
      return closest_.find({.point = p, .within = within_, .near_enough = within_}).has_value();
    });
  }

 private:
  FaceTree tree_;
  ClosestPoints closest_{tree_};
  double within_;
};

/// @param thin_faces  Thin faces of the complex, ascending.
/// @complexity        O(#F log #F).
FlatComponents find_flat_components(const PassInput& input, std::span<const Index> thin_faces) {
  const CutMesh& cut = input.mesh.cut();
  const Components components = find_edge_components(cut);
  const std::vector<Index> n_others = count_others(components, cut.side, thin_faces);
  FlatComponents flat;
  std::map<Index, std::vector<Index>> faces_of;
  for (const Index f : thin_faces) {
    const Index component = components.of_face[cut.side.mesh_face(f)];
    if (n_others[component] != 0) continue;
    flat.faces.push_back(f);
    faces_of[component].push_back(f);
  }
  if (faces_of.empty()) return flat;
  const RestOfMesh rest(input, flat.faces);
  for (const auto& [component, faces] : faces_of) {
    if (input.wants_to_stop()) break;
    if (rest.are_near(places_of(input.tracked.soup, faces))) flat.needless.push_back(faces);
  }
  return flat;
}

/// The maximum number of steps that depend on each other in one operation.
constexpr std::size_t kMaxStepsTogether = 512;

/// The repairs that are permitted.
enum class Effort : std::uint8_t {
  /// Only the thin faces themselves change: short edges are collapsed, and caps are retracted.
  Least,
  /// Edges of any length are collapsed too, and edges between thin faces are flipped.
  Any,
};

/// Mends thin faces one after the other, and then those that become mendable: first with minimal
/// changes as far as that goes, then with any.
///
/// Each step leaves fewer vertices, or as many and fewer thin faces, or as many of both and a
/// shorter edge; so the process ends.
class Mender {
 public:
  Mender(const PassInput& input, std::span<const Index> thin_faces)
      : input_(input),
        soup_(input.tracked.soup),
        rules_(input),
        mesh_(input.tracked.soup, thin_faces, input.tolerances.degeneracy),
        journal_(input.operation_size == OperationSize::Smallest ? 1 : kMaxStepsTogether) {}

  void mend(std::span<const Index> faces) {
    for (const Index f : faces) push(f);
    mend_queue(Effort::Least);
    // The next round continues where this one had to stop.
    if (has_deferred_) return;
    std::vector<Index> left;
    for (const auto& [face, outcome] : failed_) left.push_back(face);
    std::sort(left.begin(), left.end());
    for (const Index f : left) push(f);
    mend_queue(Effort::Any);
  }

  [[nodiscard]] Edits edits() const { return journal_.edits(soup_, mesh_); }

  /// Appends those of the given faces that could not be mended.
  void report(const DefectList& defects, std::vector<Refusal>& refused) const {
    for (const Defect& defect : defects) {
      const Index face = defect.faces.front();
      const auto found = failed_.find(face);
      if (found == failed_.end() || !mesh_.is_thin(face)) continue;
      const bool is_too_far = found->second == MendOutcome::TooFar;
      refused.push_back({.code = defect.code,
                         .face = face,
                         .reason = std::string(mend_reason(found->second)),
                         .rejection = is_too_far ? Rejection::TooFar : Rejection::None});
    }
  }

 private:
  void push(Index face) {
    if (is_queued_.insert(face).second) queue_.push_back(face);
  }

  void mend_queue(Effort effort) {
    while (!queue_.empty() && !input_.wants_to_stop()) {
      const Index f = queue_.front();
      queue_.pop_front();
      is_queued_.erase(f);
      if (mesh_.is_thin(f)) mend(f, effort);
    }
  }

  void push_if_thin(Index face) {
    if (mesh_.is_thin(face)) push(face);
  }

  void mend(Index face, Effort effort) {
    const MendAttempt attempt = best_attempt(face, effort);
    if (!attempt.is_possible()) {
      failed_[face] = attempt.outcome;
      return;
    }
    failed_.erase(face);
    if (!journal_.record(mesh_, attempt.step)) {
      has_deferred_ = true;
      return;
    }
    const std::vector<Index> concerned = vertices_of(attempt.step);
    const std::size_t n_faces = mesh_.n_faces();
    mesh_.make(attempt.step);
    for (const MendStep::NewCorners& change : attempt.step.changed) push_if_thin(change.face);
    for (std::size_t f = n_faces; f < mesh_.n_faces(); ++f) push_if_thin(static_cast<Index>(f));
    for (const Index v : concerned) try_again_at(v);
  }

  [[nodiscard]] MendAttempt best_attempt(Index face, Effort effort) const {
    const Triangle& t = mesh_.triangle(face);
    const FacetShape shape = measure_facet(mesh_.corners(t));
    if (is_short(shape.lengths[shape.shortest_edge()])) return collapse_short_edge(t, shape);
    const MendAttempt retracted = retract_cap(
        mesh_, rules_, face,
        effort == Effort::Least ? RetractGain::FewerThin : RetractGain::FewerThinOrShorter);
    if (retracted.is_possible() || effort == Effort::Least) return retracted;
    MendAttempt best = retracted;
    for (std::size_t k = 0; k < 3; ++k) {
      const MendAttempt collapsed = collapse_edge(mesh_, rules_, {t[k], t[(k + 1) % 3]});
      best = better(best, collapsed);
    }
    return best;
  }

  /// Returns the shortest edge that can be collapsed.
  [[nodiscard]] MendAttempt collapse_short_edge(const Triangle& t, const FacetShape& shape) const {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return shape.lengths[a] < shape.lengths[b];
    });
    MendAttempt best;
    for (const std::size_t k : order) {
      if (!is_short(shape.lengths[k]) || best.is_possible()) break;
      const MendAttempt collapsed = collapse_edge(mesh_, rules_, {t[k], t[(k + 1) % 3]});
      best = better(best, collapsed);
    }
    return best;
  }

  [[nodiscard]] bool is_short(double length) const {
    return length < rules_.tolerance() || length == 0.0;
  }

  /// Lists the vertices of the faces of a step, before and after it.
  [[nodiscard]] std::vector<Index> vertices_of(const MendStep& step) const {
    std::vector<Index> vertices;
    for (const MendStep::NewCorners& change : step.changed) {
      const Triangle& old = mesh_.triangle(change.face);
      vertices.insert(vertices.end(), old.begin(), old.end());
      if (change.corners == kNoTriangle) continue;
      vertices.insert(vertices.end(), change.corners.begin(), change.corners.end());
    }
    sort_unique(vertices);
    return vertices;
  }

  /// Queues the faces at a vertex that could not be mended before, unless the vertex has so many
  /// that it would take too long.
  void try_again_at(Index vertex) {
    if (failed_.empty() || mesh_.faces_at(vertex).size() > kMostFacesRoundVertex) return;
    for (const Index f : mesh_.faces_at(vertex)) {
      if (failed_.contains(f)) push(f);
    }
  }

  const PassInput& input_;
  const Soup& soup_;
  MendRules rules_;
  WorkingMesh mesh_;
  StepJournal journal_;
  std::deque<Index> queue_;
  std::unordered_set<Index> is_queued_;
  /// Indexed by face: the reason why it was left when it was last examined.
  std::unordered_map<Index, MendOutcome> failed_;
  bool has_deferred_ = false;
};

/// Appends the operation of dropping some faces.
void drop(const std::vector<Index>& faces, Edits& edits) {
  const Index op = edits.begin_operation();
  for (const Index f : faces) edits.removed_faces.push_back({op, f});
}

void mend_in_complex(const PassInput& input, const DefectList& defects, PassResult& result) {
  std::vector<Index> thin;
  for (const Defect& defect : defects) thin.push_back(defect.faces.front());
  const FlatComponents flat = find_flat_components(input, thin);
  std::vector<Index> mendable;
  std::set_difference(thin.begin(), thin.end(), flat.faces.begin(), flat.faces.end(),
                      std::back_inserter(mendable));
  Mender mender(input, thin);
  mender.mend(mendable);
  result.edits = mender.edits();
  result.has_smaller_operations = true;
  mender.report(defects, result.refused);
  std::unordered_set<Index> dropped;
  for (const std::vector<Index>& faces : flat.needless) {
    drop(faces, result.edits);
    dropped.insert(faces.begin(), faces.end());
  }
  for (const Defect& defect : defects) {
    const Index f = defect.faces.front();
    if (dropped.contains(f) || !std::binary_search(flat.faces.begin(), flat.faces.end(), f)) {
      continue;
    }
    result.refused.push_back(
        {defect.code, kNoIndex, f,
         "all faces of its component are flat, and no other surface is where it is"});
  }
}

}  // namespace

PassResult mend_facets(const PassInput& input) {
  DefectList in_complex;
  std::vector<Index> rejected;
  for (const Defect& defect : find_thin_facets(input.mesh, input.tolerances)) {
    const Index f = defect.faces.front();
    if (is_in_complex(input.tracked.soup.triangles[f])) {
      in_complex.push_back(defect);
    } else {
      rejected.push_back(f);
    }
  }
  PassResult result;
  if (!in_complex.empty()) mend_in_complex(input, in_complex, result);
  for (const Index f : rejected) drop({f}, result.edits);
  return result;
}

}  // namespace meshalyzer
