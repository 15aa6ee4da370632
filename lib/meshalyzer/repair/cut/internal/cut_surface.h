#pragma once

#include "meshalyzer/repair/cut/internal/select_pieces.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The changes to a mesh that are made before it is cut.
struct ChangesBefore {
  /// Faces on vertices of the mesh that are added.
  std::span<const Edits::AddedFace> patches;
  /// #vertices: where they are; empty if they stay in place.
  std::span<const Vec3> positions;
  /// CutSurface::n_first_pairs of the mesh with all vertices in place; 0 if that is not known.
  std::size_t n_pairs_in_place = 0;
};

/// A surface with its intersecting faces cut: positions and faces alone.
struct CutSurface {
  /// Vertices of the input keep their numbers, and are where ChangesBefore has placed them; later
  /// ones are new.
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// #triangles: the face of the input that each is a part of; n_faces + i for patch face i.
  std::vector<Index> origins;
  /// The walls that were removed, with faces as `origins` names them.
  std::vector<InteriorWall> walls;
  /// The number of pairs that the first round was to cut.
  std::size_t n_first_pairs = 0;
  /// The area of the dropped pockets, relative to the area that stays.
  double pocket_share = 0.0;
  /// Tells whether a round has met pockets, whatever became of them; if not, SelectOptions::pockets
  /// makes no difference.
  bool has_pockets = false;
  /// Tells whether thin facets were removed; if not, ThinFacets makes no difference.
  bool has_removed_facets = false;
  /// Tells whether cutting was given up because there would be too many pieces, crossings, or
  /// digits of exact points.
  bool has_too_many_pieces = false;
  /// Sets of faces of the input whose parts stay or are dropped together.
  std::vector<std::array<Index, 2>> ties;
  /// Faces of the input with parts that still intersect others in the end.
  std::vector<Index> unfinished;
  /// Faces of the input that were cut and belong to a sheet.
  std::vector<Index> of_sheets;
  /// Loose faces of the input that intersect others.
  std::vector<Index> loose;
  /// Faces of the input that intersect others, belong to sheets, and are left.
  std::vector<Index> of_uncut_sheets;
};

/// The treatment of facets below the degeneracy tolerance that cutting makes.
enum class ThinFacets : std::uint8_t {
  Kept,
  /// Thin facets are removed as remove_slivers() does it, unless faces then intersect again and
  /// again, or the tolerance is not small against the maximum deviation.
  Removed,
};

/// What becomes of the pieces, and how many may be made.
struct PieceRules {
  ThinFacets thin_facets = ThinFacets::Kept;
  /// The maximum number of pieces beside a multiple of the faces of the input, which is smaller for
  /// those that stay: every later pass would take time for each of them.
  std::size_t more_pieces = 100'000;
};

/// Cuts the intersecting faces, keeps the parts that bound the solid, and rounds new vertices. This
/// is repeated until no faces intersect, because the rounded faces may intersect anew.
///
/// The pairs that are cut are those of pairs_to_cut(). Faces of no area are dropped, and the faces
/// round them are cut at their corners.
///
/// The search ends early, with pairs that still intersect, if it is told to stop, if the pairs that
/// rounding makes multiply, even if slivers are removed, or moving the vertices has multiplied
/// them, if it takes too many tests to find them, or if there are too many pieces.
[[nodiscard]] CutSurface cut_surface(const PassInput& input, const ChangesBefore& changes,
                                     const SelectOptions& options, const PieceRules& rules);

/// Does the same, and keeps the pockets and the thin facets; drops small pockets if rounding makes
/// it impossible to keep them; if that fails too, tries both again with wider slivers removed.
///
/// @param more_pieces  See PieceRules.
[[nodiscard]] CutSurface cut_keeping_pockets(const PassInput& input, const ChangesBefore& changes,
                                             Sheets sheets, std::size_t more_pieces);

}  // namespace meshalyzer
