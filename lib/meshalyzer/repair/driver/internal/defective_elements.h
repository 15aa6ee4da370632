#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A face, edge or vertex that is part of a defect, identified by key. The acceptance check
/// compares the elements before and after a change.
struct DefectiveElement {
  enum class Element : std::uint8_t { Vertex, Edge, Face };
  DefectCode code = DefectCode::Hole;
  Element element = Element::Face;
  /// The key of the face or vertex, or the two keys of the edge with the smaller first. The second
  /// is kNoIndex if there is one only.
  std::array<Index, 2> keys{kNoIndex, kNoIndex};

  friend auto operator<=>(const DefectiveElement&, const DefectiveElement&) = default;
};

/// Finds the defective elements of a mesh, in ascending order: thin facets (degenerate ones too, as
/// flat-facet), border edges (as hole), non-manifold edges and vertices, flipped edges, and
/// duplicate faces beyond the first. Defects that require a spatial search are left out.
///
/// @complexity O(#V + #F).
[[nodiscard]] std::vector<DefectiveElement> find_defective_elements(const TrackedMesh& tracked,
                                                                    const PreparedMesh& mesh,
                                                                    const Tolerances& tolerances);

}  // namespace meshalyzer
