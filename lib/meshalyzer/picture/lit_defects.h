#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/picture/neighbourhoods.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the picture module: which defects are lit up, and how much of each.

/// What is lit up of a defect: the first of its elements. Only refers to them.
struct LitDefect {
  /// Index into DefectReport::defects.
  std::size_t number = 0;
  /// Of a whole component (disjoint, inward) the faces of that component.
  std::span<const Index> faces;
  std::span<const std::array<Index, 2>> edges;
  std::span<const IntersectingPair> pairs;
  std::span<const Index> vertices;
  /// Whether there are more.
  bool is_cut = false;
};

/// The largest number such that the sizes, none counted for more than it, add up to at most a
/// total; at least 1 and at most `max_each`.
/// @complexity O(#sizes log max_each).
[[nodiscard]] std::size_t fair_share(std::span<const std::size_t> sizes, std::size_t max_each,
                                     std::size_t total);

/// The defects of a report that are lit up. The mesh and the report must outlive it.
class LitDefects {
 public:
  LitDefects(const PreparedMesh& mesh, const DefectReport& report, const SceneLimits& limits);
  LitDefects(const LitDefects&) = delete;
  LitDefects& operator=(const LitDefects&) = delete;

  /// In the order of the report.
  [[nodiscard]] std::span<const LitDefect> all() const { return lit_; }
  /// Where they are: the first element of each, errors before warnings, then the second of each,
  /// and so on, so that a long one does not take all there is.
  [[nodiscard]] Seeds seeds(const Soup& soup) const;

 private:
  const DefectReport& report_;
  std::vector<LitDefect> lit_;
  /// Those that some defects are, flat, as far as they may be lit up.
  std::vector<std::vector<Index>> components_;
};

}  // namespace meshalyzer
