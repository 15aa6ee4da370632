#pragma once

#include "meshalyzer/repair/cut/internal/select_pieces.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// A surface of which the intersecting faces were cut, by its positions and faces alone.
struct CutSurface {
  /// Vertices of the input keep their numbers; those beyond are new.
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// #triangles: the face of the input that each is a part of; n_faces + i for patch face i.
  std::vector<Index> origins;
  /// The walls that are gone, with faces as `origins` names them.
  std::vector<InteriorWall> walls;
  /// The area of the pockets that went, relative to what stays.
  double pocket_share = 0.0;
  /// Faces of the input of which parts stay or go together.
  std::vector<std::array<Index, 2>> ties;
  /// Faces of the input of which parts still intersect others in the end.
  std::vector<Index> unfinished;
  /// Faces of the input that intersect others and are of a sheet.
  std::vector<Index> of_sheets;
};

/// Cuts the faces that intersect, keeps what bounds the solid, and rounds new vertices, again and
/// again until no faces intersect: the rounded faces may intersect anew.
///
/// Faces that are only not welded are left alone, as far as they meet no others. Faces of no area
/// go: what is left of them is cut at their corners.
///
/// It ends early, with what still intersects, when it is to stop, or when rounding makes more pairs
/// than a multiple of those that there were.
///
/// @param patches  Faces that are added before, on vertices of the mesh.
[[nodiscard]] CutSurface cut_surface(const PassInput& input,
                                     std::span<const Edits::AddedFace> patches, Pockets pockets);

}  // namespace meshalyzer
