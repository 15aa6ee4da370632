#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/cut/internal/cut_topology.h"
#include "meshalyzer/repair/holes/internal/fill_loop.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/tangles.h"
#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The largest number of faces of a place that is refilled, and of edges round it.
constexpr std::size_t kMostFacesRefilled = 1'000;
constexpr std::size_t kMostEdgesRound = 200;
/// As many rings of faces are taken from round a broken place at most.
constexpr std::size_t kMostRings = 3;

/// The edges round broken places, by their ends, the lower first.
class EdgesOfPlaces {
 public:
  explicit EdgesOfPlaces(const Soup& soup, const std::vector<std::vector<Index>>& places) {
    for (Index place = 0; place < places.size(); ++place) {
      for (const Index face : places[place]) {
        const Triangle& t = soup.triangles[face];
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
          edges_.push_back({low, high, place});
        }
      }
    }
    sort_unique(edges_);
  }

  /// Returns the place that has an edge; kNoIndex if none has it.
  [[nodiscard]] Index place_at(Index a, Index b) const {
    const auto [low, high] = std::minmax(a, b);
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), Edge{low, high, 0});
    const bool is_found = found != edges_.end() && (*found)[0] == low && (*found)[1] == high;
    return is_found ? (*found)[2] : kNoIndex;
  }

 private:
  using Edge = std::array<Index, 3>;
  /// Ascending: two vertices and the place.
  std::vector<Edge> edges_;
};

/// A place, and what it is refilled with.
struct Refill {
  /// The faces that go, ascending.
  std::vector<Index> faces;
  Patch patch;
};

/// Finds the places where cutting does not keep the topology, by a trial. It is made when it is
/// first needed, because it takes as long as cutting.
class CutTrial {
 public:
  CutTrial(const PassInput& input, const PassFunction& cut) : input_(input), cut_(cut) {}

  /// Tells whether cutting would leave a place broken, or change its topology.
  [[nodiscard]] bool fails_at(const std::vector<Index>& faces) {
    if (!is_alike_) {
      is_alike_ = faces_replaced_alike(input_.tracked.soup, cut_(input_).edits);
    }
    return std::none_of(faces.begin(), faces.end(),
                        [&](Index face) { return (*is_alike_)[face] != 0; });
  }

 private:
  const PassInput& input_;
  const PassFunction& cut_;
  std::optional<std::vector<std::uint8_t>> is_alike_;
};

/// Finds patches for the holes that are left where the faces at tangles are taken away.
class RefillSearch {
 public:
  RefillSearch(const PassInput& input, Tangles tangles, CutTrial& cut)
      : input_(input),
        cut_(cut),
        soup_(input.mesh.soup()),
        tangles_(std::move(tangles)),
        rest_(tangles_.rest),
        loops_(find_hole_loops(rest_)),
        edges_(soup_, tangles_.places),
        existing_(rest_, loops_.loops) {}

  std::vector<Refill> run() {
    find_loops_of_places();
    std::vector<Refill> refills;
    for (Index place = 0; place < tangles_.places.size(); ++place) {
      if (std::optional<Patch> patch = patch_for(place)) {
        refills.push_back({std::move(tangles_.places[place]), std::move(*patch)});
      }
    }
    return refills;
  }

 private:
  /// A place is left if a loop round it is not its own, or is no loop.
  void find_loops_of_places() {
    loops_of_.resize(tangles_.places.size());
    is_left_.assign(tangles_.places.size(), 0);
    std::vector<std::size_t> n_edges(tangles_.places.size(), 0);
    for (const HalfedgeHandle h : find_border_edges(rest_.cut())) {
      const auto [a, b] = file_ends(rest_.cut(), h);
      const Index place = edges_.place_at(a, b);
      if (place != kNoIndex) ++n_edges[place];
    }
    for (std::size_t i = 0; i < loops_.loops.size(); ++i) {
      const HoleLoop& loop = loops_.loops[i];
      const Index place = edges_.place_at(loop.vertices[0], loop.next(0));
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Index here = edges_.place_at(loop.vertices[k], loop.next(k));
        if (here == place) continue;
        for (const Index p : {here, place}) {
          if (p != kNoIndex) is_left_[p] = 1;
        }
      }
      if (place == kNoIndex) continue;
      loops_of_[place].push_back(i);
      n_edges[place] -= std::min(n_edges[place], loop.size());
    }
    for (Index place = 0; place < is_left_.size(); ++place) {
      if (n_edges[place] != 0 || loops_of_[place].size() != 1 || !is_disc(place)) {
        is_left_[place] = 1;
      }
    }
  }

  [[nodiscard]] bool is_disc(Index place) const {
    std::vector<Triangle> faces;
    for (const Index face : tangles_.places[place]) faces.push_back(soup_.triangles[face]);
    return topology_of(faces) == SurfaceTopology{.euler_characteristic = 1, .components = 1};
  }

  [[nodiscard]] bool is_fixed(Index place) const {
    const std::vector<Index>& faces = tangles_.places[place];
    return std::any_of(faces.begin(), faces.end(), [&](Index face) {
      return input_.limits.has_fixed_corner(input_.tracked, face);
    });
  }

  [[nodiscard]] const HoleLoop& loop_of(Index place) const {
    return loops_.loops[loops_of_[place].front()];
  }

  /// Returns a patch for a place that is within the deviation, if cutting is no better.
  [[nodiscard]] std::optional<Patch> patch_for(Index place) {
    if (is_left_[place] != 0 || is_fixed(place) || loop_of(place).size() > kMostEdgesRound) {
      return std::nullopt;
    }
    std::optional<Patch> patch = fan_of(place);
    for (const FillShape shape : {FillShape::Auto, FillShape::Linear}) {
      if (patch && is_near(place, *patch)) break;
      patch = filled(place, shape);
    }
    if (!patch || !is_near(place, *patch) || !cut_.fails_at(tangles_.places[place])) {
      return std::nullopt;
    }
    return patch;
  }

  /// Returns the triangles between the loop round a place and the vertex within that is nearest to
  /// the middle of all vertices within.
  [[nodiscard]] std::optional<Patch> fan_of(Index place) const {
    const HoleLoop& loop = loop_of(place);
    const std::optional<Index> centre = middle_vertex(place, loop);
    if (!centre) return std::nullopt;
    Patch fan;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      fan.triangles.push_back({loop.vertices[i], loop.next(i), *centre});
    }
    if (!is_sound(rest_, fan)) return std::nullopt;
    return fan;
  }

  [[nodiscard]] std::optional<Index> middle_vertex(Index place, const HoleLoop& loop) const {
    std::vector<Index> round = loop.vertices;
    sort_unique(round);
    std::vector<Index> within;
    for (const Index face : tangles_.places[place]) {
      for (const Index v : soup_.triangles[face]) {
        if (!std::binary_search(round.begin(), round.end(), v)) within.push_back(v);
      }
    }
    sort_unique(within);
    if (within.empty()) return std::nullopt;
    Vec3 middle = Vec3::Zero();
    for (const Index v : within) middle += soup_.positions[v] / static_cast<double>(within.size());
    return *std::min_element(within.begin(), within.end(), [&](Index a, Index b) {
      return (soup_.positions[a] - middle).squaredNorm() <
             (soup_.positions[b] - middle).squaredNorm();
    });
  }

  [[nodiscard]] std::optional<Patch> filled(Index place, FillShape shape) const {
    const FillTask task{.mesh = rest_,
                        .existing = existing_,
                        .degeneracy = input_.tolerances.degeneracy,
                        .shape = shape,
                        .wants_to_stop = input_.wants_to_stop};
    return fill_loop(task, {.loop = loop_of(place), .bridges = {}}).patch;
  }

  /// Tells whether the corners and middles of the old faces are within the deviation of the new
  /// surface. All of both surfaces is measured only for what is proposed.
  [[nodiscard]] bool is_near(Index place, const Patch& patch) {
    const double within = input_.limits.max_deviation;
    if (!closest_) closest_.emplace(rest_.tree());
    const auto is_point_near = [&](const Vec3& point) {
      const bool is_on_patch =
          std::any_of(patch.triangles.begin(), patch.triangles.end(), [&](const Triangle& t) {
            return closest_on_triangle(corners_of(soup_, patch, t), point).distance <= within;
          });
      return is_on_patch || closest_->find({.point = point, .within = within}).has_value();
    };
    const std::vector<Index>& faces = tangles_.places[place];
    return std::all_of(faces.begin(), faces.end(), [&](Index face) {
      const Corners old = corners_of(soup_, face);
      return is_point_near(centroid_of(old)) && std::all_of(old.begin(), old.end(), is_point_near);
    });
  }

  const PassInput& input_;
  CutTrial& cut_;
  const Soup& soup_;
  Tangles tangles_;
  PreparedMesh rest_;
  HoleLoops loops_;
  EdgesOfPlaces edges_;
  ExistingEdges existing_;
  std::vector<std::vector<std::size_t>> loops_of_;
  /// #places: 1 for those that cannot be refilled.
  std::vector<std::uint8_t> is_left_;
  std::optional<ClosestPoints> closest_;
};

Index nearest_of(const Soup& soup, const std::vector<Index>& faces, const Vec3& point) {
  const auto distance = [&](Index face) {
    return closest_on_triangle(corners_of(soup, face), point).distance;
  };
  return *std::min_element(faces.begin(), faces.end(),
                           [&](Index a, Index b) { return distance(a) < distance(b); });
}

void propose(const Soup& soup, const Refill& refill, Edits& edits) {
  const Index op = edits.begin_operation();
  for (const Index face : refill.faces) edits.removed_faces.push_back({op, face});
  const auto shift = static_cast<Index>(edits.added_vertices.size());
  for (const Vec3& p : refill.patch.added) edits.added_vertices.push_back({op, p});
  for (Triangle t : refill.patch.triangles) {
    const Vec3 middle = centroid_of(corners_of(soup, refill.patch, t));
    const Index prototype = nearest_of(soup, refill.faces, middle);
    for (Index& v : t) v += v >= soup.n_vertices() ? shift : 0;
    edits.added_faces.push_back({.op = op, .corners = t, .prototype = prototype});
  }
}

}  // namespace

PassResult refill_tangles(const PassInput& input, const PassFunction& cut) {
  if (input.limits.groups == Groups::Faces || input.mesh.intersecting_pairs().empty()) return {};
  CutTrial trial(input, cut);
  std::vector<Refill> refills;
  std::vector<Index> refilled;
  // All rings are tried in one run, because after a change of the mesh another trial is needed.
  for (std::size_t n_rings = 0; n_rings <= kMostRings; ++n_rings) {
    Tangles tangles =
        find_tangles(input.mesh, {.n_rings = n_rings, .max_faces = kMostFacesRefilled}, refilled);
    if (tangles.places.empty()) continue;
    for (Refill& refill : RefillSearch(input, std::move(tangles), trial).run()) {
      refilled.insert(refilled.end(), refill.faces.begin(), refill.faces.end());
      refills.push_back(std::move(refill));
    }
  }
  std::vector<Patch> patches;
  for (const Refill& refill : refills) patches.push_back(refill.patch);
  const std::vector<std::uint8_t> is_kept = keep_apart(input.mesh, patches);
  PassResult result;
  for (std::size_t i = 0; i < refills.size(); ++i) {
    if (is_kept[i] != 0) propose(input.mesh.soup(), refills[i], result.edits);
  }
  return result;
}

}  // namespace meshalyzer
