#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/passes.h"

#include <cstddef>

/// Holes punched into meshes, so that the lost surface is known.
namespace meshalyzer::test {

/// A mesh that has lost the faces near one of its vertices.
struct PunchedMesh {
  Soup open;
  /// The lost faces, by the vertices of `open`.
  Soup lost;
  /// The middle and the size of the hole: twice the largest distance of a lost vertex from the
  /// middle.
  Vec3 place = Vec3::Zero();
  double diameter = 0.0;
};

/// Removes all faces whose three corners are within a radius of a vertex.
[[nodiscard]] PunchedMesh punch(const Soup& closed, Index vertex, double radius);

/// The ways to fill a hole here.
enum class Filling : std::uint8_t {
  /// The pass fills it, in the shape that it chooses.
  Auto,
  Linear,
  Smooth,
  /// The triangulation of the border that has the least area fills it.
  LeastArea,
};

/// The distances between a patch and the lost surface, as fractions of the diameter of the hole.
struct FillError {
  /// The mean distance of points spread evenly over the patch from the lost surface.
  double mean = 0.0;
  /// The largest distance of any sample of either from the other.
  double largest = 0.0;
  std::size_t n_faces = 0;
};

/// Fills the hole and measures the distances.
///
/// @return  Infinite errors if no patch was found.
[[nodiscard]] FillError fill_error(const PunchedMesh& punched, Filling filling);

}  // namespace meshalyzer::test
