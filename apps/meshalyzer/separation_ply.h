#pragma once

#include "meshalyzer/set/separation.h"

#include <optional>
#include <string>

namespace meshalyzer {

/// The picture of an object.
struct SeparationPicture {
  /// The mesh file.
  const std::string& path;
  const ObjectSeparation& separation;
  /// The distance with the last colour; where nothing, the largest there is.
  std::optional<double> largest;
};

/// Writes a picture of a mesh: the mesh with the separation of each vertex as its quality and
/// colour.
///
/// Magnitudes run along viridis from 0 on; where a vertex lies inside another mesh, all go along a
/// diverging map that is white at 0. Vertices without a distance are grey and have quality NaN.
///
/// @param file  Written in place of what is there; its folder must be there.
/// @throws IoError if a file cannot be read or written.
void write_separation_ply(const std::string& file, const SeparationPicture& picture);

}  // namespace meshalyzer
