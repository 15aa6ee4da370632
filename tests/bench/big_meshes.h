#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer::bench {

/// Makes a mesh of about `faces` faces that is hard in one named way:
///
/// - `wavy`: a torus with waves on it, closed, one component, nothing coplanar: what a scan or a
/// reconstruction is like
/// - `flat`: a cube whose sides are grids, so that nearly all neighbours are coplanar: subdivided
/// or CAD meshes
/// - `subdivided`: `wavy` with each face split in four twice, so that three in four neighbours are
/// coplanar but for rounding
/// - `cad`: 24 bolts askew to the axes, round as CAD programs write them: coplanar fans round one
/// vertex of the rim, and walls of slivers
/// - `slivers`: a closed tube along a diagonal of space of faces a thousand times longer than wide
/// - `beam`: a long beam, two of whose walls are fans round one of its corners: half of the faces
/// are long, nearly parallel slivers, whose boxes meet each other and the short faces beside them
/// - `crossing`: two wavy tori through each other
/// - `onion`: cubes in each other, a thousand deep, turned outward and inward in turn
/// - `fan`: a double cone, so that two vertices have half of all faces each
/// - `damaged`: `wavy` with a thousand scattered defects, see damaged()
/// - `shards`: triangles without common vertices, touching nothing
/// - `orphans`: a tetrahedron, and as many vertices that no face uses as faces are asked for
/// - `tangle`: random triangles in a cube, of which more than a quarter of all pairs cross
/// - `shuffled`: `wavy` with its vertices and faces in no order, so that neighbours lie far apart
/// in memory
///
/// @throws InvalidArgument for another name.
[[nodiscard]] Soup big_mesh(std::string_view kind, std::size_t faces);

}  // namespace meshalyzer::bench
