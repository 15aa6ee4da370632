#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/edits/draft.h"

#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// One element that is not as it should be, by key: what tells whether a change does more harm than
/// good.
struct Flaw {
  enum class Element : std::uint8_t { Vertex, Edge, Face };
  DefectCode code = DefectCode::Hole;
  Element element = Element::Face;
  /// One key, or the two of an edge, smaller first (else kNoIndex second).
  std::array<Index, 2> keys{kNoIndex, kNoIndex};

  friend auto operator<=>(const Flaw&, const Flaw&) = default;
};

/// The flaws of a mesh, ascending: thin facets (as flat-facet, degenerate ones too), border edges
/// (as hole), non-manifold edges and vertices, flipped edges, duplicate faces beyond the first.
/// Not those that take a search in space.
///
/// @complexity O(#V + #F).
[[nodiscard]] std::vector<Flaw> find_flaws(const Draft& draft, const PreparedMesh& mesh,
                                           const Tolerances& tolerances);

}  // namespace meshalyzer
