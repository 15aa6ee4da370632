#include "meshalyzer/io/rewrite/merged_vertices.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/rewrite/blend.h"
#include "meshalyzer/io/rewrite/face_plan.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>

namespace meshalyzer {
namespace {

class MergeFinder {
 public:
  MergeFinder(const EditedMesh& mesh, const std::vector<Index>& numbers)
      : mesh_(mesh), numbers_(numbers), merged_into_(numbers.size(), kNoIndex) {}

  std::vector<MergedVertex> find() {
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const Index model = model_of(mesh_.faces[f]);
      if (model == kNoIndex) continue;
      for (const Index old : mesh_.source.triangles[model]) {
        if (old != kNoIndex && numbers_[old] == kNoIndex && merged_into_[old] == kNoIndex) {
          merged_into_[old] = vertex_in_place(static_cast<Index>(f), model, old);
        }
      }
    }
    std::vector<MergedVertex> merged;
    for (std::size_t v = 0; v < merged_into_.size(); ++v) {
      if (merged_into_[v] == kNoIndex) continue;
      const Index kept = mesh_.vertices[merged_into_[v]].record;
      if (kept != kNoIndex && kept != v) {
        merged.push_back({static_cast<Index>(v), merged_into_[v], kept});
      }
    }
    return merged;
  }

 private:
  /// Returns the corner of a face that was none before and is nearest to a dropped one; kNoIndex if
  /// there is none. A face that was made of another one may have lost that corner.
  [[nodiscard]] Index vertex_in_place(Index face, Index model, Index old) const {
    const bool is_same = mesh_.faces[face].relation == ElementOrigin::Relation::Same;
    const Triangle& before = mesh_.source.triangles[model];
    Index nearest = kNoIndex;
    double smallest = is_same ? std::numeric_limits<double>::infinity() : 0.0;
    for (const Index v : mesh_.soup.triangles[face]) {
      const bool is_old = v == kNoIndex || std::find(before.begin(), before.end(),
                                                     mesh_.vertices[v].record) != before.end();
      if (is_old) continue;
      const double distance = (mesh_.soup.positions[v] - mesh_.source.positions[old]).norm();
      if (distance <= smallest) {
        nearest = v;
        smallest = distance;
      }
    }
    return nearest;
  }

  const EditedMesh& mesh_;
  /// The new number of each vertex record; kNoIndex if it was dropped.
  const std::vector<Index>& numbers_;
  /// The vertex of the edited mesh in the place of each dropped one.
  std::vector<Index> merged_into_;
};

/// #vertices: true for those that had a face in common with the vertex that took their place.
std::vector<bool> which_collapsed(const Soup& source, const std::vector<MergedVertex>& merged) {
  std::vector<Index> kept(source.n_vertices(), kNoIndex);
  for (const MergedVertex& m : merged) kept[m.gone] = m.kept;
  std::vector<bool> is_collapsed(kept.size(), false);
  for (const Triangle& t : source.triangles) {
    for (const Index v : t) {
      if (v != kNoIndex && kept[v] != kNoIndex &&
          std::find(t.begin(), t.end(), kept[v]) != t.end()) {
        is_collapsed[v] = true;
      }
    }
  }
  return is_collapsed;
}

}  // namespace

VertexMerges find_vertex_merges(const EditedMesh& mesh, const std::vector<Index>& numbers) {
  VertexMerges merges{.merged = MergeFinder(mesh, numbers).find(), .names = numbers};
  for (const MergedVertex& m : merges.merged) merges.names[m.gone] = m.now;
  const std::vector<bool> is_collapsed = which_collapsed(mesh.source, merges.merged);
  std::erase_if(merges.merged, [&](const MergedVertex& m) { return is_collapsed[m.gone]; });
  return merges;
}

bool are_joined(std::vector<Index> names, const std::vector<Index>& numbers) {
  const auto by_number = [&](Index a, Index b) {
    return std::tie(numbers[a], a) < std::tie(numbers[b], b);
  };
  std::sort(names.begin(), names.end(), by_number);
  return std::adjacent_find(names.begin(), names.end(), [&](Index a, Index b) {
           return a != b && numbers[a] == numbers[b];
         }) != names.end();
}

bool are_lost_in(std::span<const std::string_view> gone, std::span<const std::string_view> kept) {
  return !gone.empty() && !std::equal(gone.begin(), gone.end(), kept.begin(), kept.end(),
                                      [](std::string_view a, std::string_view b) {
                                        return a == b || parse_real(a) == parse_real(b);
                                      });
}

}  // namespace meshalyzer
