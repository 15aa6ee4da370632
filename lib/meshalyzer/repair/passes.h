#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/repair/facets/turning_over.h"
#include "meshalyzer/repair/holes/fill_options.h"
#include "meshalyzer/repair/pass.h"

#include <cstdint>
#include <optional>
#include <span>

namespace meshalyzer {

// The repairs, one a file. Each is a pass (see PassFunction), some with options.

/// Drops records that cannot be part of a mesh: faces with a corner that no record defines, and
/// vertex records that repeat an id. A face record that repeats an id gets a new one.
[[nodiscard]] PassResult drop_corrupt(const PassInput& input);

/// Drops all but one of the faces with the same three vertices, and keeps the first of those that
/// are oriented consistently with most of their neighbours. Opposed faces that have no other face
/// at their edges are all dropped, because one alone would be open.
///
/// Such faces may be a wall between two solids, with as many faces in one direction as in the
/// other, and the rest of the mesh closed without it. All of them are dropped if all of the wall is
/// within the deviation of the rest, and the solids become one. Else one of each direction stays,
/// and a refusal says so: each solid needs its side, which split_edges() gives it.
[[nodiscard]] PassResult drop_duplicates(const PassInput& input);

/// Drops equal faces as drop_duplicates() does, except that one of each direction stays of those
/// that are closed by themselves. So no point of the surface moves farther than the deviation.
[[nodiscard]] PassResult drop_surplus_duplicates(const PassInput& input);

/// Drops copies: components each face of which has its corners at the positions of those of a face
/// of one other component, whatever its direction. Of equal components the first one stays.
[[nodiscard]] PassResult drop_copies(const PassInput& input);

/// Removes degenerate and flat facets (see find_thin_facets()): drops those that repeat a vertex,
/// collapses the short edge of needles and others, and flips the longest edge of caps or splits the
/// face beyond it. It turns no neighbour over, and keeps the topology and the maximum deviation.
[[nodiscard]] PassResult mend_facets(const PassInput& input);

/// Mends degenerate and flat facets that mend_facets() leaves, in a mesh where nothing else can be
/// repaired: by the best step that makes no faces intersect; cuts necks that are thinner than the
/// tolerance; and drops components without a body that lie within the deviation of the rest.
[[nodiscard]] PassResult mend_remaining_facets(const PassInput& input);

/// Widens degenerate and flat facets that nothing takes away: moves one vertex of each, by a few
/// times the tolerance at most, so that the facet is as wide as that. It makes no contact.
[[nodiscard]] PassResult widen_facets(const PassInput& input, TurningOver turning);

/// Joins border edges, only with border edges, and never so that an edge gets a third face: those
/// at exactly the same position first, then those whose ends are within PassInput::length. If
/// several could be joined, those are that leave each solid closed. If several short edges lie
/// along a long one, as at T-junctions, the face of the long one is split at their vertices. Joined
/// vertices become the fixed one, that with most faces, or lowest.
///
/// If the length is longer than `within`, that of the user, because a step ends behind it, only
/// those are joined for which it makes no difference: no distance between the two decides about
/// them, nor about edges that they are connected with. So of the joins that a greater `within`
/// makes in this step, a smaller one makes none or those that it would make anyway.
[[nodiscard]] PassResult weld_borders(const PassInput& input, double within);

/// Returns the length of a step before PassInput::length in which weld_borders() may join an edge
/// at a changed vertex, or else that of the next step in which it may join more; nothing if
/// `within` is reached. The steps depend on the mesh, but not on `within`. The first one ends at
/// Tolerances::degeneracy.
///
/// @param changed  The vertices, by key, ascending.
/// @complexity     O(#F + n log n) for n border edges, unless they are dense.
[[nodiscard]] std::optional<double> next_weld_length(const PassInput& input, double within,
                                                     std::span<const Index> changed);

/// Drops the walls that divide a solid into cells, as find_walls_between_cells() finds them: the
/// cells become one solid.
[[nodiscard]] PassResult drop_dividing_walls(const PassInput& input);

/// What becomes of walls that are stored once between two cells (see find_walls_between_cells()):
/// they stay with one of the cells, or get an opposed copy, so that each has its own.
enum class SharedWalls : std::uint8_t { Left, Doubled };

/// Cuts the mesh at edges with more than two faces, into sheets that are manifold there: faces are
/// paired round the edge by angle, so that each solid stays closed.
[[nodiscard]] PassResult split_edges(const PassInput& input, SharedWalls shared);

/// Gives each fan of a vertex with several fans its own copy of the vertex.
[[nodiscard]] PassResult split_vertices(const PassInput& input);

/// Moves apart copies of a vertex that splitting has left in contact at one position, by the
/// smallest step after which the faces round them share no point.
[[nodiscard]] PassResult part_contacts(const PassInput& input);

/// Cuts off the tips of the surface that touch another part of it at copies of a vertex, where
/// part_contacts() finds no way to move them: the faces round one of the copies are cut off near
/// it, within the deviation, and the hole is filled.
[[nodiscard]] PassResult cut_off_tips(const PassInput& input);

/// Turns faces until no edge is crossed twice in the same direction. In each edge component the
/// smaller part is turned; components that cannot be oriented are left.
[[nodiscard]] PassResult orient_consistently(const PassInput& input);

/// Turns the components that are oriented inside out: closed ones by exact parity with nesting, so
/// that cavities stay cavities; open or self-intersecting ones by votes of winding numbers.
[[nodiscard]] PassResult orient_outward(const PassInput& input);

/// Removes foldovers (see find_foldovers()).
[[nodiscard]] PassResult remove_foldovers(const PassInput& input);

/// Moves foldovers of a closed mesh off what they lie on, by a few times the height tolerance.
[[nodiscard]] PassResult lift_foldovers(const PassInput& input);

/// Joins what touches at copies of vertices, where nothing else is wrong with a closed mesh: thin
/// rods along the edges at which faces touch, and at single points, are united with it. So a mesh
/// becomes manifold where neither part_contacts() nor cut_off_tips() finds room between its parts.
[[nodiscard]] PassResult join_contacts(const PassInput& input);

/// Replaces opposed normals (see opposed_normals()) by the mean normal of the faces that have them,
/// weighted by angle.
[[nodiscard]] PassResult renew_normals(const PassInput& input);

/// Returns a pass that fills holes with patches which meet neither the mesh nor themselves. By
/// PassInput::memory, a loop without one is tried again only once a face near it has changed.
[[nodiscard]] PassFunction hole_filling(const FillOptions& options);

/// Tells whether sheets that intersect something are left, with all that they intersect, or cut;
/// then they stay, except for what lies inside solids.
enum class Sheets : std::uint8_t { Left, Cut };

struct CutOptions {
  /// If given, a hole is filled even if every patch for it intersects the mesh, and the patch is
  /// cut too.
  std::optional<FillOptions> fill = {};
  Sheets sheets = Sheets::Left;
  /// Tells whether more may be cut than usual, because the result is to be good.
  bool is_for_guarantee = false;
};

/// Cuts intersecting faces along their intersections, and drops the parts that do not bound the
/// solid that they enclose (see cut_surface()).
[[nodiscard]] PassResult cut_intersections(const PassInput& input, const CutOptions& options);

/// Tells whether a pass may drop open components that bound a solid.
enum class LostParts : std::uint8_t { Refused, Allowed };

/// Takes small tangles away, discs of faces that intersect themselves, with up to three rings of
/// faces round them, and fills the holes, where cutting would not keep the topology: where it would
/// leave the tangle, or leave handles, separate parts, or edges with four faces. It proposes what
/// moves the corners and middles of the faces by no more than the deviation.
///
/// @param cut  The pass that would cut the mesh instead.
[[nodiscard]] PassResult refill_tangles(const PassInput& input, const PassFunction& cut);

struct SelfUnionOptions {
  /// The holes that are filled before.
  FillOptions fill;
  LostParts lost = LostParts::Refused;
};

/// Fills holes with patches that may intersect the mesh, cuts all of it along its intersections,
/// and keeps the boundary of the region with a winding number other than zero: the union of the
/// mesh with itself (Zhou et al. 2016, "Mesh arrangements for solid geometry").
///
/// Unlike cut_intersections() it proposes one operation for all of the mesh, or none.
[[nodiscard]] PassResult self_union(const PassInput& input, const SelfUnionOptions& options);

/// Drops vertices that no face uses.
[[nodiscard]] PassResult drop_orphans(const PassInput& input);

/// Numbers vertices and faces 1, 2, ..., n in file order.
[[nodiscard]] PassResult renumber(const PassInput& input);

/// Turns every face over, and the normals of vertices that have one; faces with a corner that no
/// record defines are left. It must run once only, because a second run turns the faces back.
[[nodiscard]] PassResult flip_all(const PassInput& input);

/// The fragments that are dropped: open parts that bound no solid, see bounds_solid().
enum class Fragments : std::uint8_t {
  /// Parts are dropped that hung, in the original mesh, on a surface that bounds a solid, and have
  /// a small fraction of its area: fins, faces that hang in a hole, and remainders of walls. Parts
  /// of which only hole patches are left are dropped too.
  Debris,
  /// Parts with a small fraction of the area of the mesh are dropped.
  Small,
  /// All fragments are dropped if a part is left that bounds a solid.
  All,
};

/// Drops fragments, which separate no inside from no outside. The last part of a mesh stays.
[[nodiscard]] PassResult drop_fragments(const PassInput& input, Fragments which);

/// Makes a thin solid of every open part that bounds none, of every closed part with one side only,
/// and of one half of every closed part in a plane, by giving it a second side and moving both
/// apart.
///
/// @param thickness  The thickness of the solid over a flat surface; a length above 0.
[[nodiscard]] PassResult thicken_sheets(const PassInput& input, double thickness);

}  // namespace meshalyzer
