#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/defects/defect_list.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"

namespace meshalyzer {

// Each finder searches one code, or two, and has a file of its own. All are pure, may be called at
// the same time, and list defects in order of their lowest element. Only find_defects() decides
// which codes are searched and how many defects are reported. doc/defects.md describes the codes.
//
// The positions of a prepared mesh must be finite; soups may be any that build() accepts.

/// Finds the components beyond the largest, which is the first of those that have the most faces. A
/// defect lists the lowest face of its component; its value is the number of faces.
[[nodiscard]] DefectList find_disjoint(const PreparedMesh& mesh);

/// Finds the regions that are folded back onto their surroundings ("Foldovers and slits" in
/// doc/definitions.md). A defect lists the faces of its region and the edges of the folds round it;
/// its value is the largest distance of the region from its surroundings, its limit the height
/// tolerance.
///
/// @param wants_to_stop  Called now and then; once it returns true, no more are found.
[[nodiscard]] DefectList find_foldovers(const PreparedMesh& mesh, const Tolerances& tolerances,
                                        const StopQuery& wants_to_stop = {});

/// Finds the faces with an altitude below the degeneracy tolerance, one defect each. A face is a
/// degenerate facet if it also has an edge below the tolerance or names a vertex twice, else a flat
/// facet. A length of exactly 0 is below any tolerance, even 0; at tolerance 0 a face is flat only
/// if its area is exactly 0. Faces with a corner that no record defines are left to find_corrupt().
/// The value is the shortest edge (0 if a vertex is repeated) or altitude, the limit the tolerance.
[[nodiscard]] DefectList find_thin_facets(const PreparedMesh& mesh, const Tolerances& tolerances);

/// Finds the chains of border edges that lie on each other, their ends within the slit tolerance
/// ("Foldovers and slits" in doc/definitions.md). A defect lists the edges of both sides; its value
/// is the largest gap, its limit the tolerance.
[[nodiscard]] DefectList find_slits(const PreparedMesh& mesh, const Tolerances& tolerances);

/// Finds the connected patches of intersecting faces. A defect lists the pairs of its patch; its
/// value is their number.
[[nodiscard]] DefectList find_self_intersection_patches(const PreparedMesh& mesh);

/// Finds the edges with more than two faces, and the vertices with more than one fan of faces that
/// are not the end of such an edge. The value is the number of faces, or of fans.
[[nodiscard]] DefectList find_non_manifold(const PreparedMesh& mesh);

/// Finds the vertices that have opposed normals (see opposed_normals()).
[[nodiscard]] DefectList find_opposed_normals(const PreparedMesh& mesh);

/// Finds, in this order, the vertices whose position is not finite, the ids that several records
/// have (the value is how many), the faces that name a vertex which no record defines (one defect
/// for each missing id), and torn lines.
[[nodiscard]] DefectList find_corrupt(const Soup& soup);

/// Finds the boundaries that are no slits, one defect each. A defect lists the edges in walking
/// order; its value is their length.
///
/// @param slits  The slits that find_slits() has found: a boundary all of whose edges belong to
///               slits is no hole.
[[nodiscard]] DefectList find_holes(const PreparedMesh& mesh, const DefectList& slits);

/// Finds the patches of faces that must be reversed to make each edge component consistent: the
/// side with less area or, if areas are equal, fewer faces. A component that no reversal makes
/// consistent is one defect that is not fixable. A defect lists the faces to be reversed and the
/// flipped edges.
[[nodiscard]] DefectList find_flipped(const PreparedMesh& mesh);

/// Finds the shells that point the wrong way: see Shell::outward. A defect lists the lowest face of
/// its component; its value is the volume.
[[nodiscard]] DefectList find_inward(const PreparedMesh& mesh);

/// Finds the faces with the same three vertices as an earlier face, one defect for each set of
/// equal faces.
[[nodiscard]] DefectList find_duplicate_facets(const PreparedMesh& mesh);

/// Finds the vertices that no face uses, one defect each. Records that repeat an id are left to
/// find_corrupt().
[[nodiscard]] DefectList find_orphans(const Soup& soup);

/// Finds ids that are not 1, 2, ..., n in file order: at most one defect for the vertices and one
/// for the faces.
[[nodiscard]] DefectList find_numbering(const Soup& soup);

}  // namespace meshalyzer
