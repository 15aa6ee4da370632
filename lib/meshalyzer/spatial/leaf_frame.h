#pragma once

#include "meshalyzer/spatial/leaf_triangles.h"

#include <array>

namespace meshalyzer {

/// Tells the faces of two leaves apart, each from each, by two directions in common.
///
/// Long faces that run side by side are mostly separated across their length. So the directions are
/// those of the slabs of one of the leaves (see Slabs).
class LeafFrame {
 public:
  LeafFrame(const LeafTriangles& faces, const std::array<std::array<float, 3>, 2>& directions);

  /// For each face of this leaf some of the faces of another one, as bits.
  using Partners = std::array<unsigned, 8>;

  /// Drops partners that are surely apart.
  void drop_apart(const LeafTriangles& others, Partners& partners) const;

 private:
  /// How far each face of the leaf reaches along a direction, widened by more than any rounding.
  struct Reaches {
    std::array<float, 3> direction;
    std::array<float, 8> low;
    std::array<float, 8> high;
  };

  static Reaches reaches_along(const std::array<float, 3>& direction, const LeafTriangles& faces);

  std::array<Reaches, 2> reaches_;
};

}  // namespace meshalyzer
