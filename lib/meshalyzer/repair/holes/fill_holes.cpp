#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/holes/internal/crossing_patches.h"
#include "meshalyzer/repair/holes/internal/fill_loop.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/holes/internal/hole_memory.h"
#include "meshalyzer/repair/holes/internal/islands.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"
#include "meshalyzer/repair/holes/internal/patch_edges.h"
#include "meshalyzer/repair/holes/internal/rim_bend.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/spatial/triangle_distance.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

TriangulationMemory* triangulations_of(const PassInput& input) {
  return input.holes == nullptr ? nullptr : &input.holes->triangulations;
}

/// Returns, by face of the patch, the file face that it is modelled on.
std::vector<Index> prototypes_of(const PreparedMesh& mesh, const HoleLoop& loop,
                                 const Patch& patch) {
  const CutMesh& cut = mesh.cut();
  const PatchEdges edges(patch);
  std::vector<Index> prototypes(patch.triangles.size(), kNoIndex);
  std::vector<Index> reached;
  const auto reach = [&](Index face, Index prototype) {
    if (face == kNoIndex || prototypes[face] != kNoIndex) return;
    prototypes[face] = prototype;
    reached.push_back(face);
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (!loop.halfedges[i].is_valid()) continue;
    reach(edges.face_at({loop.vertices[i], loop.next(i)}),
          cut.side.face(cut.mesh.face_handle(loop.halfedges[i])));
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Triangle& t = patch.triangles[reached[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      reach(edges.face_at({t[(k + 1) % 3], t[k]}), prototypes[reached[i]]);
    }
  }
  return prototypes;
}

/// Adds a patch as one operation. Each of its faces is modelled on the face beyond the border edge
/// that is reached through the fewest faces.
void add_patch(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch, Edits& edits) {
  const auto n_vertices = static_cast<Index>(mesh.soup().n_vertices());
  const auto shift = static_cast<Index>(edits.added_vertices.size());
  const Index op = edits.begin_operation();
  for (const Vec3& position : patch.added) {
    edits.added_vertices.push_back({.op = op, .position = position});
  }
  const std::vector<Index> prototypes = prototypes_of(mesh, loop, patch);
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    Triangle corners = patch.triangles[i];
    for (Index& v : corners) v += v >= n_vertices ? shift : 0;
    edits.added_faces.push_back(
        {.op = op, .corners = corners, .prototype = prototypes[i], .fills_hole = true});
  }
}

/// More loops than this are not joined to one.
constexpr std::size_t kMaxIslands = 64;
/// Loops are not joined any more after so much work in vain, one after the other, counted in the
/// cubes of the lengths of joined loops. In a heap of faces the patch of each hole meets dozens of
/// others, and no patch of them all is free of intersections either.
constexpr double kMaxVainWork = 5e7;

/// Tells which loops may be filled; some of the others may still be joined to one of these.
struct Choice {
  std::vector<std::uint8_t> is_chosen;
  std::vector<std::uint8_t> may_join;
  /// 0 for the loops of parts that are known to bound a solid.
  std::vector<std::uint8_t> may_be_sheet;
  std::vector<Refusal> refused;
};

/// Returns the distance of a point from the nearest edge between a face that filled a hole and one
/// that did not.
double distance_from_patches(const PassInput& input, const Vec3& point) {
  const CutMesh& cut = input.mesh.cut();
  const auto fills_hole = [&](HalfedgeHandle h) {
    const FaceHandle f = cut.mesh.face_handle(h);
    return input.tracked.origin_of_face(cut.side.face(f)) == kNoIndex;
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (const EdgeHandle e : cut.mesh.edges()) {
    const HalfedgeHandle h = cut.mesh.halfedge_handle(e, 0);
    if (cut.mesh.is_boundary(e) ||
        fills_hole(h) == fills_hole(cut.mesh.opposite_halfedge_handle(h))) {
      continue;
    }
    const Vec3& a = cut.mesh.point(cut.mesh.from_vertex_handle(h));
    const Vec3& b = cut.mesh.point(cut.mesh.to_vertex_handle(h));
    nearest = std::min(nearest, closest_on_triangle({a, b, b}, point).distance);
  }
  return nearest;
}

/// Refuses all loops that are not chosen.
void refuse_others(const PreparedMesh& mesh, std::span<const HoleLoop> loops,
                   const std::string& reason, Choice& choice) {
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (choice.is_chosen[i] == 0) choice.refused.push_back(refuse_hole(mesh, loops[i], reason));
  }
}

/// Keeps only the loop nearest to a point; none if a still nearer one was filled before.
void choose_nearest(const PassInput& input, std::span<const HoleLoop> loops, const Vec3& point,
                    Choice& choice) {
  std::vector<double> distances;
  for (const HoleLoop& loop : loops) {
    distances.push_back(distance_from(input.mesh.soup(), loop, point));
  }
  const auto nearest = std::min_element(distances.begin(), distances.end());
  choice.is_chosen.assign(loops.size(), 0);
  if (*nearest < distance_from_patches(input, point)) {
    choice.is_chosen[static_cast<std::size_t>(nearest - distances.begin())] = 1;
  }
  refuse_others(input.mesh, loops, "another hole is nearer to the point that was asked for",
                choice);
}

/// Removes the loops of sheets.
void refuse_sheets(const PassInput& input, std::span<const HoleLoop> loops, Choice& choice) {
  const PreparedMesh& mesh = input.mesh;
  const Components components = find_edge_components(mesh.cut());
  const std::vector<std::uint8_t> is_solid = bounds_solid(mesh, components, input.wants_to_stop);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Index component = components.of(mesh.cut().mesh, loops[i].halfedges.front());
    if (is_solid[component] != 0) choice.may_be_sheet[i] = 0;
    if (choice.is_chosen[i] == 0 || is_solid[component] != 0) continue;
    choice.is_chosen[i] = 0;
    choice.refused.push_back(
        refuse_hole(mesh, loops[i],
                    "the surface is a sheet: it is left open unless hole filling is asked for by "
                    "name"));
  }
}

Choice choose_loops(const PassInput& input, std::span<const HoleLoop> loops,
                    const FillOptions& options) {
  Choice choice{.is_chosen = std::vector<std::uint8_t>(loops.size(), 1),
                .may_join = std::vector<std::uint8_t>(loops.size(), 1),
                .may_be_sheet = std::vector<std::uint8_t>(loops.size(), 1),
                .refused = {}};
  if (options.at) choose_nearest(input, loops, *options.at, choice);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].size() <= options.max_edges) continue;
    if (choice.is_chosen[i] != 0) {
      choice.refused.push_back(
          refuse_hole(input.mesh, loops[i], "it has more edges than the holes to be filled"));
    }
    choice.is_chosen[i] = 0;
    choice.may_join[i] = 0;
  }
  const bool is_any_left =
      std::find(choice.is_chosen.begin(), choice.is_chosen.end(), 1) != choice.is_chosen.end();
  if (options.sheets == FillSheets::No && is_any_left) refuse_sheets(input, loops, choice);
  return choice;
}

/// A patch, and the loop that it fills.
struct FilledLoop {
  JoinedLoop loop;
  /// The numbers of the loops that it closes, ascending.
  std::vector<std::size_t> members;
  Patch patch;
};

/// Fills the loops of a mesh, except those that share a vertex with a loop filled in this round.
class HoleFiller {
 public:
  HoleFiller(const FillTask& task, std::span<const HoleLoop> loops, Choice choice)
      : task_(task),
        soup_(task.mesh.soup()),
        loops_(loops),
        choice_(std::move(choice)),
        islands_(task.mesh, task.existing, loops),
        is_used_(soup_.n_vertices(), 0) {}

  [[nodiscard]] PassResult run() {
    for (const std::size_t i : by_length()) {
      if (task_.wants_to_stop()) break;
      if (choice_.is_chosen[i] != 0 && is_free(i)) fill(i);
    }
    return result();
  }

 private:
  /// Returns the loops, the longest first: an outer loop finds its islands before these are
  /// examined.
  [[nodiscard]] std::vector<std::size_t> by_length() const {
    std::vector<double> lengths;
    for (const HoleLoop& loop : loops_) lengths.push_back(length_of(soup_, loop));
    std::vector<std::size_t> order(loops_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
    return order;
  }

  /// Tells whether no loop that is filled in this round has a vertex of this one.
  [[nodiscard]] bool is_free(std::size_t i) const {
    return std::none_of(loops_[i].vertices.begin(), loops_[i].vertices.end(),
                        [&](Index v) { return is_used_[v] != 0; });
  }

  void fill(std::size_t i) {
    const JoinedLoop alone{.loop = loops_[i], .bridges = {}};
    if (islands_.may_hold_any(i)) {
      const std::optional<Patch> first = first_patch(task_, alone);
      if (first && fill_joined(i, islands_.lying_on(*first, i))) return;
    }
    Filling filling = fill_loop(task_, alone);
    if (filling.patch) {
      accept(with_sheets({alone, {i}, std::move(*filling.patch)}));
    } else if (!filling.first ||
               !fill_joined(i, islands_.along(faces_met(task_.mesh, *filling.first), i))) {
      failures_.push_back({i, std::move(filling.reason)});
    }
  }

  /// Joins a loop with the sheets that face its patch: they would stay open, or get a patch of
  /// their own beside it. The patch of the joined loop may be nearer to more of them.
  [[nodiscard]] FilledLoop with_sheets(FilledLoop filled) {
    const std::size_t i = filled.members.front();
    std::vector<std::size_t> joined;
    while (true) {
      std::vector<std::size_t> facing = sheets_facing(filled.patch, i);
      facing.insert(facing.end(), joined.begin(), joined.end());
      sort_unique(facing);
      if (facing.size() == joined.size()) return filled;
      std::optional<FilledLoop> next = try_joined(i, facing);
      if (!next || !bends_less(*next, filled)) return filled;
      filled = std::move(*next);
      joined = std::move(facing);
    }
  }

  /// Returns the loops of sheets that face a patch.
  [[nodiscard]] std::vector<std::size_t> sheets_facing(const Patch& patch, std::size_t i) const {
    std::vector<std::size_t> found = islands_.facing(patch, i);
    std::erase_if(found, [&](std::size_t k) {
      return choice_.may_be_sheet[k] == 0 || choice_.may_join[k] == 0 || !is_free(k);
    });
    return found;
  }

  /// Tells whether a joined loop bends less at its rim than if those loops that it has more than
  /// another one had patches of their own.
  [[nodiscard]] bool bends_less(const FilledLoop& joined, const FilledLoop& fewer) const {
    double bends = total_rim_bend(task_.mesh, fewer.loop.loop, fewer.patch);
    for (const std::size_t k : joined.members) {
      if (std::binary_search(fewer.members.begin(), fewer.members.end(), k)) continue;
      const std::optional<Patch> own = first_patch(task_, {.loop = loops_[k], .bridges = {}});
      if (own) bends += total_rim_bend(task_.mesh, loops_[k], *own);
    }
    return total_rim_bend(task_.mesh, joined.loop.loop, joined.patch) < bends;
  }

  /// Fills a loop together with others that may be filled.
  ///
  /// @return Whether it was filled.
  bool fill_joined(std::size_t i, std::vector<std::size_t> others) {
    std::erase_if(others, [&](std::size_t k) { return choice_.may_join[k] == 0 || !is_free(k); });
    std::optional<FilledLoop> filled = try_joined(i, others);
    if (filled) accept(std::move(*filled));
    return filled.has_value();
  }

  [[nodiscard]] std::optional<FilledLoop> try_joined(std::size_t i,
                                                     std::vector<std::size_t> others) {
    if (others.empty() || others.size() > kMaxIslands) return std::nullopt;
    if (vain_work_ > kMaxVainWork) return std::nullopt;
    std::vector<const HoleLoop*> together{&loops_[i]};
    for (const std::size_t k : others) together.push_back(&loops_[k]);
    std::optional<JoinedLoop> joined = join_loops(soup_, task_.existing, together);
    if (!joined) return std::nullopt;
    Filling filling = fill_loop(task_, *joined);
    if (!filling.patch) {
      vain_work_ += std::pow(static_cast<double>(joined->loop.size()), 3);
      return std::nullopt;
    }
    vain_work_ = 0.0;
    others.push_back(i);
    std::sort(others.begin(), others.end());
    return FilledLoop{std::move(*joined), std::move(others), std::move(*filling.patch)};
  }

  void accept(FilledLoop filled) {
    for (const Index v : filled.loop.loop.vertices) is_used_[v] = 1;
    filled_.push_back(std::move(filled));
  }

  [[nodiscard]] PassResult result() {
    PassResult result;
    std::vector<Patch> patches;
    for (const FilledLoop& filled : filled_) patches.push_back(filled.patch);
    const std::vector<std::uint8_t> is_kept = keep_apart(task_.mesh, patches);
    for (std::size_t k = 0; k < filled_.size(); ++k) {
      if (is_kept[k] == 0) continue;
      add_patch(task_.mesh, filled_[k].loop.loop, filled_[k].patch, result.edits);
    }
    result.refused = std::move(choice_.refused);
    std::sort(failures_.begin(), failures_.end());
    for (auto& [i, reason] : failures_) {
      // It may have become an island of a later loop.
      if (is_free(i)) {
        result.refused.push_back(refuse_hole(task_.mesh, loops_[i], std::move(reason)));
      }
    }
    return result;
  }

  const FillTask& task_;
  const Soup& soup_;
  std::span<const HoleLoop> loops_;
  Choice choice_;
  Islands islands_;
  /// #V: non-zero for vertices of filled loops.
  std::vector<std::uint8_t> is_used_;
  std::vector<FilledLoop> filled_;
  std::vector<std::pair<std::size_t, std::string>> failures_;
  /// See kMaxVainWork.
  double vain_work_ = 0.0;
};

PassResult fill_loops(const PassInput& input, const FillOptions& options) {
  HoleLoops found = find_hole_loops(input.mesh);
  PassResult result;
  if (!found.loops.empty()) {
    const ExistingEdges existing(input.mesh, found.loops);
    std::optional<FillMemory> memory;
    if (input.holes != nullptr) memory.emplace(input.holes->failed, input);
    const FillTask task{.mesh = input.mesh,
                        .existing = existing,
                        .degeneracy = input.tolerances.degeneracy,
                        .shape = options.shape,
                        .wants_to_stop = input.wants_to_stop,
                        .memory = memory ? &*memory : nullptr,
                        .triangulations = triangulations_of(input)};
    result = HoleFiller(task, found.loops, choose_loops(input, found.loops, options)).run();
  }
  result.refused.insert(result.refused.begin(), std::make_move_iterator(found.refused.begin()),
                        std::make_move_iterator(found.refused.end()));
  return result;
}

}  // namespace

std::vector<Edits::AddedFace> crossing_patches(const PassInput& input, const FillOptions& options) {
  const HoleLoops found = find_hole_loops(input.mesh);
  if (found.loops.empty()) return {};
  const ExistingEdges existing(input.mesh, found.loops);
  const FillTask task{.mesh = input.mesh,
                      .existing = existing,
                      .degeneracy = input.tolerances.degeneracy,
                      .shape = FillShape::Linear,
                      .wants_to_stop = input.wants_to_stop,
                      .triangulations = triangulations_of(input)};
  const Choice choice = choose_loops(input, found.loops, options);
  Edits edits;
  for (std::size_t i = 0; i < found.loops.size(); ++i) {
    if (input.wants_to_stop()) break;
    if (choice.is_chosen[i] == 0) continue;
    const std::optional<Patch> patch = first_patch(task, {.loop = found.loops[i], .bridges = {}});
    if (patch) add_patch(input.mesh, found.loops[i], *patch, edits);
  }
  return std::move(edits.added_faces);
}

PassFunction hole_filling(const FillOptions& options) {
  return [options](const PassInput& input) { return fill_loops(input, options); };
}

}  // namespace meshalyzer
