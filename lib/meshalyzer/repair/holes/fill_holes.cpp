#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/holes/internal/crossing_patches.h"
#include "meshalyzer/repair/holes/internal/fill_loop.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/holes/internal/islands.h"
#include "meshalyzer/repair/holes/internal/loop_choice.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"
#include "meshalyzer/repair/holes/internal/patch_edges.h"
#include "meshalyzer/repair/holes/internal/rim_bend.h"
#include "meshalyzer/repair/internal/pass_memory.h"
#include "meshalyzer/repair/passes.h"

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
  return input.memory == nullptr ? nullptr : &input.memory->holes.triangulations;
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
/// So many loops are looked at together, in parallel. What is found for those that are filled with
/// one of the others is not needed.
constexpr std::size_t kLoopsAtOnce = 32;
/// Loops with fewer corners, all together, do not pay a second thread.
constexpr std::size_t kCornersForThreads = 256;

/// Calls `body` for the number of each of some loops, in parallel if that pays.
template <typename Body>
void for_each_loop(std::span<const std::size_t> numbers, std::span<const HoleLoop> loops,
                   const Body& body) {
  std::size_t n_corners = 0;
  for (const std::size_t i : numbers) n_corners += loops[i].size();
  const std::size_t length =
      n_corners < kCornersForThreads ? std::max<std::size_t>(1, numbers.size()) : 1;
  parallel_chunks(numbers.size(), length, [&](Chunk chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) body(k);
  });
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
  HoleFiller(const FillTask& task, std::span<const HoleLoop> loops, LoopChoice choice)
      : task_(task),
        soup_(task.mesh.soup()),
        loops_(loops),
        choice_(std::move(choice)),
        islands_(task.mesh, task.existing, loops),
        is_used_(soup_.n_vertices(), 0) {}

  [[nodiscard]] PassResult run() {
    const std::vector<std::size_t> order = by_length();
    for (std::size_t begin = 0; begin < order.size() && !task_.wants_to_stop();
         begin += kLoopsAtOnce) {
      const std::size_t n_together = std::min(kLoopsAtOnce, order.size() - begin);
      fill_each(std::span(order).subspan(begin, n_together));
    }
    return result();
  }

 private:
  /// What is known of a loop that may be filled before the loops that come before it are.
  struct Prospect {
    /// The inner borders on its first patch that may be joined with it.
    std::vector<std::size_t> islands;
    /// If there are none, the outcome of filling it.
    Filling alone;
  };

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

  /// Fills some loops, one after the other.
  void fill_each(std::span<const std::size_t> numbers) {
    std::vector<std::size_t> may_fill;
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(may_fill),
                 [&](std::size_t i) { return choice_.is_chosen[i] != 0 && is_free(i); });
    std::vector<Prospect> prospects(may_fill.size());
    for_each_loop(may_fill, loops_, [&](std::size_t k) {
      if (!task_.wants_to_stop()) prospects[k] = prospect_of(may_fill[k]);
    });
    for (std::size_t k = 0; k < may_fill.size() && !task_.wants_to_stop(); ++k) {
      if (is_free(may_fill[k])) fill(may_fill[k], std::move(prospects[k]));
    }
  }

  [[nodiscard]] Prospect prospect_of(std::size_t i) const {
    const JoinedLoop alone{.loop = loops_[i], .bridges = {}};
    Prospect prospect;
    if (islands_.may_hold_any(i)) {
      const std::optional<Patch> first = first_patch(task_, alone);
      if (first) prospect.islands = islands_.lying_on(*first, i);
      std::erase_if(prospect.islands, [&](std::size_t k) { return choice_.may_join[k] == 0; });
    }
    if (prospect.islands.empty()) prospect.alone = fill_loop(task_, alone);
    return prospect;
  }

  void fill(std::size_t i, Prospect prospect) {
    if (fill_joined(i, prospect.islands)) return;
    JoinedLoop alone{.loop = loops_[i], .bridges = {}};
    Filling filling =
        prospect.islands.empty() ? std::move(prospect.alone) : fill_loop(task_, alone);
    if (filling.patch) {
      accept(with_sheets({std::move(alone), {i}, std::move(*filling.patch)}));
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
  LoopChoice choice_;
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
    if (input.memory != nullptr) memory.emplace(input.memory->holes.failed, input);
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
  const LoopChoice choice = choose_loops(input, found.loops, options);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < found.loops.size(); ++i) {
    if (choice.is_chosen[i] != 0) chosen.push_back(i);
  }
  std::vector<std::optional<Patch>> patches(chosen.size());
  for_each_loop(chosen, found.loops, [&](std::size_t k) {
    if (input.wants_to_stop()) return;
    patches[k] = first_patch(task, {.loop = found.loops[chosen[k]], .bridges = {}});
  });
  Edits edits;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (patches[k]) add_patch(input.mesh, found.loops[chosen[k]], *patches[k], edits);
  }
  return std::move(edits.added_faces);
}

PassFunction hole_filling(const FillOptions& options) {
  return [options](const PassInput& input) { return fill_loops(input, options); };
}

}  // namespace meshalyzer
