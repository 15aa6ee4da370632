#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/picture/internal/neighbourhoods.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// The elements of a defect or change that are highlighted: the first ones. It only refers to them.
struct HighlightedElements {
  /// The position of the defect in DefectReport::defects, or of the change in its list.
  std::size_t number = 0;
  /// The faces; those of the whole component if the defect is one (disjoint, inward).
  std::span<const Index> faces;
  std::span<const std::array<Index, 2>> edges;
  std::span<const IntersectingPair> pairs;
  std::span<const Index> vertices;
  /// The positions that are highlighted if nothing else is visible.
  std::span<const Vec3> positions;
  /// Tells whether the faces are too thin to be seen as faces.
  bool is_thin = false;
  /// Tells whether there are more elements.
  bool is_cut = false;
};

/// Returns the largest number such that the sizes, each cut to that number, add up to at most
/// `total`. It is at least 1 and at most `max_each`.
///
/// @complexity O(#sizes log max_each).
[[nodiscard]] std::size_t fair_share(std::span<const std::size_t> sizes, std::size_t max_each,
                                     std::size_t total);

/// Chooses the elements of changes that are highlighted; the changes must outlive them.
[[nodiscard]] std::vector<HighlightedElements> elements_of_changes(
    std::span<const ChangedPlace> changes, const SceneLimits& limits);

/// Chooses the defects of a report that are highlighted.
class HighlightedDefects {
 public:
  HighlightedDefects(const PreparedMesh& mesh, const DefectReport& report,
                     const SceneLimits& limits);
  HighlightedDefects(const HighlightedDefects&) = delete;
  HighlightedDefects& operator=(const HighlightedDefects&) = delete;

  /// Returns the chosen defects, in the order of the report.
  [[nodiscard]] std::span<const HighlightedElements> all() const { return elements_; }
  /// Returns the elements round which the mesh is drawn in detail: the first element of each
  /// defect, errors before warnings, then the second of each, and so on, so that one long defect
  /// does not take all the detail.
  [[nodiscard]] Seeds seeds(const Soup& soup) const;

 private:
  /// The chosen defects, to whose lists elements_ refers.
  std::vector<Defect> defects_;
  std::vector<HighlightedElements> elements_;
  /// The faces of each component that is a defect, as many as may be highlighted.
  std::vector<std::vector<Index>> components_;
};

}  // namespace meshalyzer
