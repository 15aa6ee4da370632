#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"

namespace meshalyzer {

/// Builds the half-edge mesh of a file's complex, cut open where it is not manifold or not
/// consistently oriented.
///
/// The mesh holds every face of the file that names three different defined vertices. Building
/// never fails, and depends on the order of the faces only in their numbering. An edge is cut when
/// it has more than two faces, or two that cross it in the same direction; a vertex is copied once
/// for each fan beyond the first that is left round it (Guéziec et al. 2001, "Cutting and
/// stitching: converting sets of polygons to manifold surfaces", local cuts without stitching). A
/// cut edge inside a fan may leave two border edges between the same two mesh vertices.
///
/// Vertices that no face uses are isolated vertices of the mesh. The connectivity is linked in
/// bulk.
///
/// @throws InvalidArgument if the soup contradicts itself (see Soup), as where a corner is neither
///         kNoIndex nor an index into positions; or the complex has more than 2^30 faces, or the
///         mesh more edges or vertices than OpenMesh's handles can number (about 2^30 and 2^31).
/// @complexity O(#V + #F) time, apart from sorting the edges round each vertex; about 48 bytes of
///             temporary memory per face.
[[nodiscard]] CutMesh build(const Soup& soup);

}  // namespace meshalyzer
