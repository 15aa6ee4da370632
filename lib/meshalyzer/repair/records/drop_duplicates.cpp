#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Faces on the same three vertices.
struct EqualFaces {
  /// The faces, ascending.
  std::vector<Index> faces;
  /// Indexed like faces: non-zero for those that face the same way as the first.
  std::vector<std::uint8_t> is_like_first;

  /// Tells whether equal numbers face each way.
  [[nodiscard]] bool cancel_out() const;
  /// Returns the first face that does not face the same way as the first one; kNoIndex if all do.
  [[nodiscard]] Index first_opposed() const;
  [[nodiscard]] bool are_all_alike() const { return first_opposed() == kNoIndex; }
};

bool EqualFaces::cancel_out() const {
  const auto n_like_first = std::count(is_like_first.begin(), is_like_first.end(), 1);
  return 2 * static_cast<std::size_t>(n_like_first) == faces.size();
}

Index EqualFaces::first_opposed() const {
  const auto opposed = std::find(is_like_first.begin(), is_like_first.end(), 0);
  if (opposed == is_like_first.end()) return kNoIndex;
  return faces[static_cast<std::size_t>(opposed - is_like_first.begin())];
}

/// Tells whether a face crosses the edge from a to b in this direction.
bool crosses(const Triangle& t, Index a, Index b) {
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

/// The counts of the faces beside the candidates at an edge.
enum class Rest : std::uint8_t { None, Closed, Otherwise };

class WallFinder {
 public:
  WallFinder(const WorkingMesh& mesh, std::span<const EqualFaces> sets)
      : mesh_(mesh),
        sets_(sets),
        walls_(sets.size()),
        has_closed_edge_(sets.size(), 0),
        has_other_edge_(sets.size(), 0) {
    for (std::size_t s = 0; s < sets.size(); ++s) {
      if (!sets[s].cancel_out()) continue;
      for (const Index f : sets[s].faces) candidate_of_[f] = static_cast<Index>(s);
    }
  }

  [[nodiscard]] std::vector<Index> find() {
    for (Index s = 0; s < sets_.size(); ++s) {
      if (sets_[s].cancel_out()) classify_edges(s);
    }
    std::vector<std::uint8_t> is_wall(sets_.size(), 0);
    for (Index s = 0; s < sets_.size(); ++s) is_wall[walls_.find(s)] |= has_closed_edge_[s];
    for (Index s = 0; s < sets_.size(); ++s) {
      if (has_other_edge_[s] != 0) is_wall[walls_.find(s)] = 0;
    }
    std::vector<Index> walls(sets_.size(), kNoIndex);
    for (Index s = 0; s < sets_.size(); ++s) {
      if (is_wall[walls_.find(s)] != 0) walls[s] = walls_.find(s);
    }
    return walls;
  }

 private:
  void classify_edges(Index set) {
    const Triangle& t = mesh_.triangle(sets_[set].faces.front());
    for (std::size_t k = 0; k < 3; ++k) {
      const Rest rest = classify_edge(set, t[k], t[(k + 1) % 3]);
      if (rest == Rest::Closed) has_closed_edge_[set] = 1;
      if (rest == Rest::Otherwise) has_other_edge_[set] = 1;
    }
  }

  [[nodiscard]] Rest classify_edge(Index set, Index a, Index b) {
    bool is_alone = true;
    int balance = 0;
    for (const Index f : mesh_.faces_at(a, b)) {
      const auto candidate = candidate_of_.find(f);
      if (candidate == candidate_of_.end()) {
        is_alone = false;
        balance += crosses(mesh_.triangle(f), a, b) ? 1 : -1;
      } else {
        walls_.unite(set, candidate->second);
      }
    }
    if (is_alone) return Rest::None;
    return balance == 0 ? Rest::Closed : Rest::Otherwise;
  }

  const WorkingMesh& mesh_;
  std::span<const EqualFaces> sets_;
  DisjointSets walls_;
  /// Indexed by set: whether it has an edge like this.
  std::vector<std::uint8_t> has_closed_edge_;
  std::vector<std::uint8_t> has_other_edge_;
  std::unordered_map<Index, Index> candidate_of_;
};

/// Finds the walls between touching solids that each set belongs to: sets that cancel out, joined
/// through edges, without which the rest of the mesh is closed round them. At each edge of a wall
/// as many other faces cross it in one direction as in the other, and there are some somewhere.
///
/// @return #sets: the wall of each, from 0; kNoIndex for those that belong to none.
std::vector<Index> find_inner_walls(const WorkingMesh& mesh, std::span<const EqualFaces> sets) {
  return WallFinder(mesh, sets).find();
}

EqualFaces equal_faces_of(const Soup& soup, const Defect& defect) {
  EqualFaces set{defect.faces, {}};
  const Triangle& first = soup.triangles[set.faces.front()];
  for (const Index f : set.faces) {
    set.is_like_first.push_back(crosses(soup.triangles[f], first[0], first[1]) ? 1 : 0);
  }
  return set;
}

/// Finds sets of faces that all face the same way, each of which closes a surface of its own, as
/// where two solids that overlap have a side in common: with all of them, as many faces cross an
/// edge in one direction as in the other, and with one of them not.
class SharedSides {
 public:
  SharedSides(const WorkingMesh& mesh, std::span<const EqualFaces> sets)
      : mesh_(mesh), sets_(sets), sides_(sets.size()), is_needed_(sets.size(), 0) {
    for (Index s = 0; s < sets.size(); ++s) {
      for (const Index f : sets[s].faces) set_of_[f] = s;
    }
  }

  /// @return #sets: 1 for those of which no face can go.
  [[nodiscard]] std::vector<std::uint8_t> find() {
    for (Index s = 0; s < sets_.size(); ++s) {
      if (!sets_[s].are_all_alike()) continue;
      const Triangle& t = mesh_.triangle(sets_[s].faces.front());
      for (std::size_t k = 0; k < 3; ++k) judge_edge(s, t[k], t[(k + 1) % 3]);
    }
    std::vector<std::uint8_t> is_of_needed(sets_.size(), 0);
    for (Index s = 0; s < sets_.size(); ++s) is_of_needed[sides_.find(s)] |= is_needed_[s];
    for (Index s = 0; s < sets_.size(); ++s) is_needed_[s] = is_of_needed[sides_.find(s)];
    return std::move(is_needed_);
  }

 private:
  /// Sets that meet at an edge are parts of one side.
  void judge_edge(Index set, Index a, Index b) {
    int with_all = 0;
    int with_one = 0;
    for (const Index f : mesh_.faces_at(a, b)) {
      const int step = crosses(mesh_.triangle(f), a, b) ? 1 : -1;
      with_all += step;
      const auto other = set_of_.find(f);
      if (other == set_of_.end()) {
        with_one += step;
        continue;
      }
      // Nothing is known of what becomes of sets that face both ways.
      if (!sets_[other->second].are_all_alike()) return;
      if (sets_[other->second].faces.front() == f) with_one += step;
      sides_.unite(set, other->second);
    }
    if (with_all == 0 && with_one != 0) is_needed_[set] = 1;
  }

  const WorkingMesh& mesh_;
  std::span<const EqualFaces> sets_;
  std::unordered_map<Index, Index> set_of_;
  DisjointSets sides_;
  std::vector<std::uint8_t> is_needed_;
};

/// What is dropped of faces that are closed by themselves.
enum class PillowFaces : std::uint8_t { All, AllButOneOfEachDirection };

/// Decides which of equal faces are dropped, set by set or wall by wall.
class DuplicateDropper {
 public:
  DuplicateDropper(const PassInput& input, const DefectList& defects, PillowFaces dropped)
      : max_deviation_(input.limits.max_deviation),
        dropped_(dropped),
        mesh_(input.tracked.soup, {}, 0.0) {
    is_in_set_.resize(input.tracked.soup.n_faces(), 0);
    for (const Defect& defect : defects) {
      sets_.push_back(equal_faces_of(input.tracked.soup, defect));
      for (const Index f : defect.faces) is_in_set_[f] = 1;
    }
  }

  [[nodiscard]] PassResult run() {
    const std::vector<Index> wall_of = find_inner_walls(mesh_, sets_);
    const std::vector<std::uint8_t> is_shared_side = SharedSides(mesh_, sets_).find();
    std::map<Index, std::vector<Index>> walls;
    for (Index s = 0; s < sets_.size(); ++s) {
      if (is_pillow(sets_[s])) {
        keep(dropped_ == PillowFaces::All ? std::vector<Index>() : one_of_each(sets_[s]), sets_[s]);
      } else if (is_shared_side[s] != 0) {
        result_.refused.push_back({DefectCode::DuplicateFacet, kNoIndex, sets_[s].faces.front(),
                                   "it is a side of two solids that overlap, and each needs it"});
      } else if (wall_of[s] == kNoIndex) {
        keep({best_of(sets_[s])}, sets_[s]);
      } else {
        walls[wall_of[s]].push_back(s);
      }
    }
    for (const auto& [number, wall] : walls) treat_wall(wall);
    return std::move(result_);
  }

 private:
  /// Tells whether faces are closed by themselves, so that one of them alone would be open.
  [[nodiscard]] bool is_pillow(const EqualFaces& set) const {
    const Triangle& t = mesh_.triangle(set.faces.front());
    const auto has_no_other_face = [&](std::size_t k) {
      return mesh_.faces_at(t[k], t[(k + 1) % 3]).size() == set.faces.size();
    };
    return set.cancel_out() && has_no_other_face(0) && has_no_other_face(1) && has_no_other_face(2);
  }

  /// Returns the first of those that fit best to their neighbours: that are oriented consistently
  /// with most of the single other faces at their edges.
  [[nodiscard]] Index best_of(const EqualFaces& set) const {
    // Opposed faces agree with those neighbours with which the first does not.
    if (set.are_all_alike() || agreement_of_first(set) >= 0) return set.faces.front();
    return set.first_opposed();
  }

  /// Returns the number of neighbours with which the first face is oriented consistently, less the
  /// number of the others.
  [[nodiscard]] int agreement_of_first(const EqualFaces& set) const {
    const Triangle& t = mesh_.triangle(set.faces.front());
    int score = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      std::vector<Index> others = mesh_.faces_at(a, b);
      std::erase_if(others, [&](Index f) {
        return std::binary_search(set.faces.begin(), set.faces.end(), f);
      });
      if (others.size() == 1) score += crosses(mesh_.triangle(others[0]), a, b) ? -1 : 1;
    }
    return score;
  }

  /// Returns the first face of each direction of a set that has both.
  [[nodiscard]] static std::vector<Index> one_of_each(const EqualFaces& set) {
    return {set.faces.front(), set.first_opposed()};
  }

  /// Drops all faces of a set but these.
  void keep(const std::vector<Index>& kept, const EqualFaces& set) {
    if (set.faces.size() == kept.size()) return;
    const Index op = result_.edits.begin_operation();
    for (const Index f : set.faces) {
      if (std::find(kept.begin(), kept.end(), f) == kept.end()) {
        result_.edits.removed_faces.push_back({op, f});
      }
    }
  }

  void treat_wall(const std::vector<Index>& wall) {
    const bool is_narrow =
        std::all_of(wall.begin(), wall.end(), [&](Index s) { return is_near_to_rim(sets_[s]); });
    if (is_narrow) {
      const Index op = result_.edits.begin_operation();
      for (const Index s : wall) {
        for (const Index f : sets_[s].faces) result_.edits.removed_faces.push_back({op, f});
      }
      return;
    }
    for (const Index s : wall) {
      const EqualFaces& set = sets_[s];
      keep(one_of_each(set), set);
      result_.refused.push_back({DefectCode::DuplicateFacet, kNoIndex, set.faces.front(),
                                 "it is the wall of two solids that touch, and each needs it"});
    }
  }

  /// Tells whether all of a face of a wall is certainly within the deviation of other faces: all
  /// its corners belong to them, and no point of a face is farther from its nearest corner than the
  /// length of its longest edge.
  [[nodiscard]] bool is_near_to_rim(const EqualFaces& set) const {
    const Triangle& t = mesh_.triangle(set.faces.front());
    const FacetShape shape = measure_facet(mesh_.corners(t));
    return shape.lengths[shape.longest_edge()] <= max_deviation_ &&
           std::all_of(t.begin(), t.end(), [&](Index v) { return is_used_elsewhere(v); });
  }

  [[nodiscard]] bool is_used_elsewhere(Index vertex) const {
    const auto faces = mesh_.faces_at(vertex);
    return std::any_of(faces.begin(), faces.end(), [&](Index f) { return is_in_set_[f] == 0; });
  }

  double max_deviation_;
  PillowFaces dropped_;
  WorkingMesh mesh_;
  std::vector<EqualFaces> sets_;
  std::vector<std::uint8_t> is_in_set_;
  PassResult result_;
};

PassResult drop_equal_faces(const PassInput& input, PillowFaces dropped) {
  const DefectList defects = find_duplicate_facets(input.mesh);
  if (defects.empty()) return {};
  return DuplicateDropper(input, defects, dropped).run();
}

}  // namespace

PassResult drop_duplicates(const PassInput& input) {
  return drop_equal_faces(input, PillowFaces::All);
}

PassResult drop_surplus_duplicates(const PassInput& input) {
  return drop_equal_faces(input, PillowFaces::AllButOneOfEachDirection);
}

}  // namespace meshalyzer
