#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <vector>

namespace meshalyzer {

// One finder a code, or two; each in a file of its own. All are pure, safe to call at the same
// time, and list defects in order of their lowest element. None reads more than the mesh: what is
// reported, and how much of it, is for find_defects() to say.

/// Components beyond the largest (by faces; of equal ones the first is the largest). The lowest
/// face names the component; value: its number of faces.
[[nodiscard]] std::vector<Defect> find_disjoint(const PreparedMesh& mesh);

/// Regions that are folded back onto their surroundings; see doc/definitions.md. Faces of the
/// region, edges of the folds round it; value: the largest distance of the region from its
/// surroundings; limit: the height tolerance.
[[nodiscard]] std::vector<Defect> find_foldovers(const PreparedMesh& mesh,
                                                 const Tolerances& tolerances);

/// Faces with an altitude below the degeneracy tolerance, one defect each; those with an edge below
/// it, or a repeated vertex, are degenerate-facet, the others flat-facet. A length of exactly 0 is
/// below any tolerance, 0 included; no face is flat at tolerance 0 whose area is not exactly 0.
/// Faces with a corner that no record defines are for find_corrupt(). Value: the shortest edge (0
/// where a vertex is repeated) or altitude; limit: the tolerance.
[[nodiscard]] std::vector<Defect> find_thin_facets(const PreparedMesh& mesh,
                                                   const Tolerances& tolerances);

/// Border edges that lie on each other: chains of pairs whose ends are within the slit tolerance.
/// Edges of both sides; value: the largest gap; limit: the tolerance.
[[nodiscard]] std::vector<Defect> find_slits(const PreparedMesh& mesh,
                                             const Tolerances& tolerances);

/// Connected patches of intersecting faces, with their pairs; value: the number of pairs. Fixable
/// where every pair is the matter of another fix (duplicate, unwelded, fold-over).
[[nodiscard]] std::vector<Defect> find_self_intersection_patches(const PreparedMesh& mesh);

/// Edges with more than two faces (value: how many), and vertices with more than one fan that are
/// not the end of such an edge (value: how many fans).
[[nodiscard]] std::vector<Defect> find_non_manifold(const PreparedMesh& mesh);

/// Vertices with a given normal that is opposed to all faces of non-zero area there, of which there
/// is one at least. Exact.
[[nodiscard]] std::vector<Defect> find_opposed_normals(const PreparedMesh& mesh);

/// Whether all coordinates are finite numbers. Only find_corrupt(), find_orphans() and
/// find_numbering() can do with a mesh of which this is not true, and nobody may build it.
[[nodiscard]] bool has_finite_positions(const Soup& soup);

/// Vertices whose position is not finite, ids that several records have (value: how many), faces
/// that name a vertex which no record defines (one defect a missing id), torn lines. In this order.
[[nodiscard]] std::vector<Defect> find_corrupt(const Soup& soup);

/// Borders that are no slits: one defect a boundary, edges in walking order; value: its length.
///
/// @param slits  What find_slits() has found: a boundary all of whose edges are there is no hole.
[[nodiscard]] std::vector<Defect> find_holes(const PreparedMesh& mesh,
                                             const std::vector<Defect>& slits);

/// Patches of faces that must be turned for each edge component to be consistent: the smaller side
/// by area, else by faces; of a component that no turning makes consistent, one defect, not
/// fixable. Faces to be turned, and the flipped edges.
[[nodiscard]] std::vector<Defect> find_flipped(const PreparedMesh& mesh);

/// Closed, manifold and consistent components that point the wrong way, nesting considered. The
/// lowest face names the component; value: its volume.
[[nodiscard]] std::vector<Defect> find_inward(const PreparedMesh& mesh);

/// Faces with the same three vertices as an earlier one, one defect a set of equal faces.
[[nodiscard]] std::vector<Defect> find_duplicate_facets(const PreparedMesh& mesh);

/// Vertices that no face uses, one defect each; records that repeat an id are for find_corrupt().
[[nodiscard]] std::vector<Defect> find_orphans(const Soup& soup);

/// Ids that are not 1, 2, ..., n in file order: one defect for the vertices and one for the faces.
[[nodiscard]] std::vector<Defect> find_numbering(const Soup& soup);

}  // namespace meshalyzer
