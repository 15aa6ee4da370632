#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/repair/edits/internal/affected_elements.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "meshalyzer/spatial/box_tree.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// Returns the box of a face, without the corners that no record defines.
[[nodiscard]] Box3 box_of_face(const Soup& soup, Index face);

/// Finds the operations of a step by the faces that they remove or change.
class ChangedPlaces {
 public:
  /// @param before  The mesh before the step.
  /// @complexity    O(#F log n) for n changes.
  ChangedPlaces(const TrackedMesh& before, const AffectedElements& affected);

  /// Returns the operations on faces that were made of a face of the input, ascending.
  ///
  /// @complexity O(log n + found).
  [[nodiscard]] std::vector<Index> on(Index input_face) const;

  /// Returns the operations on faces whose box meets another one, ascending.
  ///
  /// @complexity O(log n + found) for faces that are spread out.
  [[nodiscard]] std::vector<Index> near(const Box3& box) const;

 private:
  /// A face of the input, and an operation on a face made of it.
  using OnOrigin = std::array<Index, 2>;

  /// The changed faces.
  struct Changed {
    std::vector<Box3> boxes;
    /// By box.
    std::vector<Index> operations;
  };

  [[nodiscard]] static Changed find_changed(const TrackedMesh& before,
                                            const AffectedElements& affected);

  /// Ascending.
  std::vector<OnOrigin> on_origins_;
  Changed changed_;
  BoxTree tree_;
};

}  // namespace meshalyzer
