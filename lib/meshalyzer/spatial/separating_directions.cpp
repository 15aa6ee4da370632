#include "meshalyzer/spatial/separating_directions.h"

#include "meshalyzer/base/eight_lanes.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

// Any direction is valid, even a rounded one; only the errors of the computed coordinates of
// corners along it matter. With u = 2^-24, and |d| the sum of the magnitudes of the direction's
// coordinates:
//
// - A coordinate of a corner is at most 1 in magnitude and rounded from a double: it is off by less
//   than 1.01 u.
// - Its product with that of the direction, and the two sums, add at most 3.03 u of their terms.
//
// So the coordinate of a corner is off by less than 4.05 u |d|, and a gap by twice that. The rest
// of the factor covers the roundings of |d|, of its product, and of the sum or difference in which
// it is used. Underflow causes an error of about 2^-148, which matters only for the shortest
// directions.
constexpr float kGapSlack = 10 * 0x1p-24F;
constexpr float kUnderflow = 0x1p-120F;

using Float3 = std::array<float, 3>;

Float3 subtracted(const Float3& a, const Float3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The template works for single numbers and for eight of them.
template <typename Vector>
Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Scales a direction to a length of about 1, so that products of directions neither overflow nor
/// vanish; zero stays zero.
Float3 near_unit_length(const Float3& v) {
  const float length = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  return length < kUnderflow ? Float3{} : Float3{v[0] / length, v[1] / length, v[2] / length};
}

/// Three coordinates of eight points or directions.
using EightVectors = std::array<EightFloats, 3>;

EightVectors loaded(const std::array<std::array<float, 8>, 3>& coordinates) {
  return {EightFloats::load(coordinates[0]), EightFloats::load(coordinates[1]),
          EightFloats::load(coordinates[2])};
}

EightVectors eight_times(const Float3& v) {
  return {EightFloats::all(v[0]), EightFloats::all(v[1]), EightFloats::all(v[2])};
}

EightFloats dot_product(const EightVectors& a, const EightVectors& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

EightFloats magnitude(const EightFloats& a) {
  return max(a, EightFloats::all(0.0F) - a);
}

using EightCorners = std::array<EightVectors, 3>;

/// The extents of eight triangles along a direction.
struct EightReaches {
  EightFloats low;
  EightFloats high;

  EightReaches(const EightVectors& directions, const EightCorners& corners) {
    const EightFloats a = dot_product(directions, corners[0]);
    const EightFloats b = dot_product(directions, corners[1]);
    const EightFloats c = dot_product(directions, corners[2]);
    low = min(min(a, b), c);
    high = max(max(a, b), c);
  }
};

EightVectors subtracted(const EightVectors& a, const EightVectors& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Tells which of eight faces have a plane with the triangle surely on one side.
EightFlags are_apart_by_planes(const EightCorners& faces, const EightCorners& triangle) {
  const EightVectors normals =
      cross_product(subtracted(faces[1], faces[0]), subtracted(faces[2], faces[0]));
  const EightFloats length = magnitude(normals[0]) + magnitude(normals[1]) + magnitude(normals[2]);
  const EightFloats slack = EightFloats::all(kGapSlack) * length + EightFloats::all(kUnderflow);
  const EightReaches theirs(normals, faces);
  const EightReaches its(normals, triangle);
  return (slack < its.low - theirs.high) | (slack < theirs.low - its.high);
}

}  // namespace

LeafTriangles::LeafTriangles(const FaceTree& tree, std::size_t leaf) {
  const std::size_t last = tree.n_faces() - 1;
  for (std::size_t i = 0; i < 8; ++i) {
    const Triangle t = tree.triangle(std::min(8 * leaf + i, last));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<float, 3> p = tree.map(tree.point(t[c]));
      for (std::size_t k = 0; k < 3; ++k) {
        corners[c][k][i] = p[k];
      }
    }
  }
}

SeparatingDirections::SeparatingDirections(const LeafTriangles& faces, std::size_t lane) {
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners_[c][k] = faces.corners[c][k][lane];
    }
  }
  const std::array<Float3, 3> edges{near_unit_length(subtracted(corners_[1], corners_[0])),
                                    near_unit_length(subtracted(corners_[2], corners_[1])),
                                    near_unit_length(subtracted(corners_[0], corners_[2]))};
  const Float3 normal = near_unit_length(cross_product(edges[0], edges[1]));
  stretches_[0] = stretch_along(normal);
  for (std::size_t i = 0; i < 3; ++i) {
    stretches_[i + 1] = stretch_along(cross_product(normal, edges[i]));
  }
}

SeparatingDirections::Stretch SeparatingDirections::stretch_along(const Float3& direction) const {
  const auto place = [&](const Float3& p) {
    return direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2];
  };
  const auto [low, high] =
      std::minmax({place(corners_[0]), place(corners_[1]), place(corners_[2])});
  const float length = std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]);
  const float slack = kGapSlack * length + kUnderflow;
  return {direction, low - slack, high + slack};
}

unsigned SeparatingDirections::perhaps_meeting(const LeafTriangles& others, unsigned lanes) const {
  const EightCorners theirs{loaded(others.corners[0]), loaded(others.corners[1]),
                            loaded(others.corners[2])};
  for (const Stretch& mine : stretches_) {
    const EightReaches reach(eight_times(mine.direction), theirs);
    const EightFlags are_apart =
        (EightFloats::all(mine.high) < reach.low) | (reach.high < EightFloats::all(mine.low));
    lanes &= ~are_apart.bits();
    if (lanes == 0) {
      return 0;
    }
  }
  const EightCorners mine{eight_times(corners_[0]), eight_times(corners_[1]),
                          eight_times(corners_[2])};
  return lanes & ~are_apart_by_planes(theirs, mine).bits();
}

}  // namespace meshalyzer
