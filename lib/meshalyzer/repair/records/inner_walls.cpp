#include "meshalyzer/repair/records/inner_walls.h"

#include "meshalyzer/topology/disjoint_sets.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace meshalyzer {
namespace {

/// What the faces beside the candidates do at an edge.
enum class Rest : std::uint8_t { None, Closed, Otherwise };

class WallFinder {
 public:
  WallFinder(const WorkingMesh& mesh, std::span<const EqualFaces> sets)
      : mesh_(mesh),
        sets_(sets),
        patches_(sets.size()),
        is_closed_(sets.size(), 0),
        is_spoilt_(sets.size(), 0) {
    for (std::size_t s = 0; s < sets.size(); ++s) {
      if (!sets[s].cancel_out()) continue;
      for (const Index f : sets[s].faces) candidate_of_[f] = static_cast<Index>(s);
    }
  }

  [[nodiscard]] std::vector<Index> find() {
    for (Index s = 0; s < sets_.size(); ++s) {
      if (sets_[s].cancel_out()) look_at(s);
    }
    std::vector<std::uint8_t> is_wall(sets_.size(), 0);
    for (Index s = 0; s < sets_.size(); ++s) is_wall[patches_.find(s)] |= is_closed_[s];
    for (Index s = 0; s < sets_.size(); ++s) {
      if (is_spoilt_[s] != 0) is_wall[patches_.find(s)] = 0;
    }
    std::vector<Index> walls(sets_.size(), kNoIndex);
    for (Index s = 0; s < sets_.size(); ++s) {
      if (is_wall[patches_.find(s)] != 0) walls[s] = patches_.find(s);
    }
    return walls;
  }

 private:
  void look_at(Index set) {
    const Triangle& t = mesh_.triangle(sets_[set].faces.front());
    for (std::size_t k = 0; k < 3; ++k) {
      const Rest rest = look_at_edge(set, t[k], t[(k + 1) % 3]);
      if (rest == Rest::Closed) is_closed_[set] = 1;
      if (rest == Rest::Otherwise) is_spoilt_[set] = 1;
    }
  }

  [[nodiscard]] Rest look_at_edge(Index set, Index a, Index b) {
    std::vector<Index> others;
    for (const Index f : mesh_.faces_at(a, b)) {
      const auto candidate = candidate_of_.find(f);
      if (candidate == candidate_of_.end()) {
        others.push_back(f);
      } else {
        patches_.unite(set, candidate->second);
      }
    }
    if (others.empty()) return Rest::None;
    const bool is_closed = others.size() == 2 && crosses(mesh_.triangle(others[0]), a, b) !=
                                                     crosses(mesh_.triangle(others[1]), a, b);
    return is_closed ? Rest::Closed : Rest::Otherwise;
  }

  const WorkingMesh& mesh_;
  std::span<const EqualFaces> sets_;
  DisjointSets patches_;
  /// By set: whether it has an edge like this.
  std::vector<std::uint8_t> is_closed_;
  std::vector<std::uint8_t> is_spoilt_;
  std::unordered_map<Index, Index> candidate_of_;
};

}  // namespace

bool EqualFaces::cancel_out() const {
  const auto n_like_first = std::count(is_like_first.begin(), is_like_first.end(), 1);
  return 2 * static_cast<std::size_t>(n_like_first) == faces.size();
}

std::vector<Index> find_inner_walls(const WorkingMesh& mesh, std::span<const EqualFaces> sets) {
  return WallFinder(mesh, sets).find();
}

bool crosses(const Triangle& t, Index a, Index b) {
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

}  // namespace meshalyzer
