#pragma once

#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/internal/skipped_operations.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {

/// A face or vertex, by key, that an operation affects.
struct AffectedElement {
  Index key = kNoIndex;
  Index operation = kNoIndex;
  friend auto operator<=>(const AffectedElement&, const AffectedElement&) = default;
};

/// The elements that a list of edits affects. Each list is ascending.
struct AffectedElements {
  /// Faces of the mesh before the edits that are removed or changed, or have a moved vertex.
  std::vector<AffectedElement> faces_before;
  /// Faces of the mesh after the edits that are changed or added, or have a moved vertex.
  std::vector<AffectedElement> faces_after;
  /// The corners of all these faces, before and after.
  std::vector<AffectedElement> vertices;
};

/// Finds the elements that edits affect.
///
/// @param after  What apply_edits() made of the mesh before.
/// @complexity   O(#F + edits log edits).
[[nodiscard]] AffectedElements find_affected_elements(const TrackedMesh& before, const Edits& edits,
                                                      const SkippedOperations& skipped,
                                                      const TrackedMesh& after);

/// Returns the entries of one element, one for each operation that affects it.
[[nodiscard]] std::span<const AffectedElement> operations_on(
    const std::vector<AffectedElement>& entries, Index key);

}  // namespace meshalyzer
