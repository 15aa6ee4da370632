#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/passes.h"

#include <cstddef>

/// Holes punched into meshes, so that what was there is known.
namespace meshalyzer::test {

/// A mesh that has lost the faces near one of its vertices.
struct PunchedMesh {
  Soup open;
  /// The faces that were there, by the vertices of `open`.
  Soup lost;
  /// Where the hole is, and how large: twice the largest distance of a lost vertex from there.
  Vec3 place = Vec3::Zero();
  double diameter = 0.0;
};

/// Takes all faces whose three corners are within a radius of a vertex.
[[nodiscard]] PunchedMesh punch(const Soup& closed, Index vertex, double radius);

/// How a hole is filled here.
enum class Filling : std::uint8_t {
  /// By the pass, as it chooses by itself.
  Auto,
  Linear,
  Smooth,
  /// By the triangulation of the border that has the least area.
  LeastArea,
};

/// The distances between a patch and what was there, as shares of the diameter of the hole.
struct FillError {
  /// Of points spread evenly over the patch from what was there.
  double mean = 0.0;
  /// Of any sample of either from the other.
  double largest = 0.0;
  std::size_t n_faces = 0;
};

/// Fills the hole and measures.
///
/// @return  Infinite errors where no patch was found.
[[nodiscard]] FillError fill_error(const PunchedMesh& punched, Filling filling);

}  // namespace meshalyzer::test
