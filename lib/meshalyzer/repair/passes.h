#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/repair/pass.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace meshalyzer {

// The repairs, one a file. Each is a pass (see PassFunction), some with options.

/// Drops what makes no mesh: faces with a corner that no record defines, vertex records that repeat
/// an id; a face record that repeats an id gets a new one.
[[nodiscard]] PassResult drop_corrupt(const PassInput& input);

/// Drops all but one of faces with the same three vertices: the first of those that cross most of
/// their edges against the one other face there. Opposed faces that have no other face at their
/// edges all go: one alone would be open.
///
/// Where they are a wall between two solids, as many facing one way as the other, and the rest of
/// the mesh is closed without it, all go if all of the wall is within the deviation of the rest: so
/// the solids become one. Else one of each direction stays, and that is refused: each solid needs
/// its side, which split_edges() gives it.
[[nodiscard]] PassResult drop_duplicates(const PassInput& input);

/// Takes away degenerate and flat facets (see find_thin_facets()): drops those that repeat a
/// vertex; needles and others with a short edge by collapsing it, caps by flipping their longest
/// edge or by splitting the face beyond it. Never turns a neighbour over, changes the topology or
/// moves anything beyond the deviation.
[[nodiscard]] PassResult mend_facets(const PassInput& input);

/// Joins border edges: those at exactly the same place first, then those whose ends are within
/// `within`, only border to border, and never so that an edge gets a third face. Where several
/// could be joined, those that leave each solid closed. Where several short edges lie along a long
/// one, as at T-junctions, the face of the long one is split at their vertices.
///
/// @param within  A length; the vertices that are joined move to one of them that is fixed, or has
/// more faces, or is the lower.
[[nodiscard]] PassResult weld_borders(const PassInput& input, double within);

/// Cuts the mesh at edges with more than two faces, into sheets that are manifold there: faces are
/// paired round the edge by angle, so that each solid stays closed.
[[nodiscard]] PassResult split_edges(const PassInput& input);

/// Gives each fan of a vertex with several a copy of its own.
[[nodiscard]] PassResult split_vertices(const PassInput& input);

/// Moves copies of a vertex that are left at one place, and touch, apart by the smallest step for
/// which the faces round them share no point.
[[nodiscard]] PassResult part_contacts(const PassInput& input);

/// Turns faces until no edge is crossed twice in the same direction, edge component by edge
/// component, the smaller part of each; components that cannot be are left.
[[nodiscard]] PassResult orient_consistently(const PassInput& input);

/// Turns the components that point the wrong way: closed ones by exact parity with nesting, so that
/// cavities stay cavities; open or self-intersecting ones by votes of winding numbers.
[[nodiscard]] PassResult orient_outward(const PassInput& input);

/// Removes foldovers (see find_foldovers()).
[[nodiscard]] PassResult remove_foldovers(const PassInput& input);

/// Replaces opposed vertex normals (see find_opposed_normals()) by the mean normal of the faces,
/// weighted by angle.
[[nodiscard]] PassResult renew_normals(const PassInput& input);

/// Tells how a hole is filled.
enum class FillShape : std::uint8_t {
  /// Smooth where the hole has more than a few edges and the surface round it bends towards it;
  /// Linear where it is flat, or ends at a crease.
  Auto,
  /// The triangulation of its border that bends least, and of those the one of least area; without
  /// new vertices, unless only they make a patch that meets nothing.
  Linear,
  /// Refined to the density round it, and faired.
  Smooth,
};

/// Tells which open parts get their holes filled.
enum class FillSheets : std::uint8_t {
  /// Only parts that bound a solid: at least half of their surface separates inside from outside.
  No,
  Yes,
};

struct FillOptions {
  /// Loops with more edges are left open.
  std::size_t max_edges = std::numeric_limits<std::size_t>::max();
  /// Where a point is given, only the loop nearest to it is filled.
  std::optional<Vec3> at = {};
  FillShape shape = FillShape::Auto;
  FillSheets sheets = FillSheets::No;
};

/// Fills holes, each with a patch that intersects neither the mesh nor itself, or not at all.
[[nodiscard]] PassResult fill_holes(const PassInput& input, const FillOptions& options);

struct CutOptions {
  /// Where given, holes that every patch for intersects the mesh are filled all the same, and the
  /// patches are cut too.
  std::optional<FillOptions> fill = {};
};

/// Cuts the faces that intersect along their intersections, and drops what does not bound the solid
/// that they enclose (see cut_surface()).
[[nodiscard]] PassResult cut_intersections(const PassInput& input, const CutOptions& options);

/// Drops vertices that no face uses.
[[nodiscard]] PassResult drop_orphans(const PassInput& input);

/// Numbers vertices and faces 1, 2, ..., n in file order.
[[nodiscard]] PassResult renumber(const PassInput& input);

/// Turns every face over, and the normals of vertices that have one; faces with a corner that no
/// record defines are left. It must run once only: a second run turns the faces back.
[[nodiscard]] PassResult flip_all(const PassInput& input);

/// Tells which fragments are dropped: open parts that bound no solid, see bounds_solid().
enum class Fragments : std::uint8_t {
  /// Parts that hung, in the original mesh, on a surface that bounds a solid, and have a small
  /// share of its area: fins, faces that hang in a hole, and what is left of walls; and parts of
  /// which only hole patches are left.
  Debris,
  /// Parts with a small share of the area of the mesh.
  Small,
  /// All, where anything is left that bounds a solid.
  All,
};

/// Drops fragments: they separate no inside from no outside. The last part of a mesh stays.
[[nodiscard]] PassResult drop_fragments(const PassInput& input, Fragments which);

/// Makes a thin solid of every open part that bounds none, and of every closed part with one side
/// only: gives it a second side, and moves both apart.
///
/// @param thickness  Of the solid, where the surface is flat; a length above 0.
[[nodiscard]] PassResult thicken_sheets(const PassInput& input, double thickness);

/// What replace_broken_solids() replaces, and how far it may go.
struct ReplaceOptions {
  /// Only what is broken, or all of the mesh.
  enum class Scope : std::uint8_t { Broken, Whole };
  Scope scope = Scope::Broken;
  /// Tells whether parts that bound no solid may be lost in it.
  enum class Sheets : std::uint8_t { Kept, Dropped };
  Sheets sheets = Sheets::Kept;
  /// Between the new surface and what it replaces.
  double max_deviation = 0.0;
};

/// What replace_broken_solids() proposes.
struct Replacement {
  PassResult result;
  /// Tells how far the new surface and what it replaces are apart at most, where they were sampled.
  double deviation = 0.0;
};

/// Replaces the components that are broken, and those that they intersect, by the contour of the
/// solid that they mean (see contour_mesh()). Walls inside the solid go, and holes are spanned.
[[nodiscard]] Replacement replace_broken_solids(const PassInput& input,
                                                const ReplaceOptions& options);

}  // namespace meshalyzer
