#pragma once

#include "meshalyzer/set/separation.h"

#include <optional>
#include <string>

namespace meshalyzer {

/// The input of the picture of an object.
struct SeparationPicture {
  /// The mesh file.
  const std::string& path;
  const ObjectSeparation& separation;
  /// The distance with the last colour; by default the largest one.
  std::optional<double> largest;
};

/// Writes a picture of a mesh: the mesh with the separation of each vertex as its quality and
/// colour.
///
/// Distances are shown with viridis from 0 on; if a vertex lies inside another mesh, with a
/// diverging map that is white at 0. Vertices without a distance are grey and have quality NaN.
///
/// @param file  The file, which is replaced if it exists; its folder must exist.
/// @throws IoError if a file cannot be read or written.
void write_separation_ply(const std::string& file, const SeparationPicture& picture);

}  // namespace meshalyzer
