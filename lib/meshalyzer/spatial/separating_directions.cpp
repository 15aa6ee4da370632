#include "meshalyzer/spatial/separating_directions.h"

#include "meshalyzer/spatial/eight_reaches.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

using Float3 = std::array<float, 3>;

/// Scales a direction to a length of about 1, so that products of directions neither overflow nor
/// vanish; zero stays zero.
Float3 near_unit_length(const Float3& v) {
  const float length = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  return length < kUnderflow ? Float3{} : Float3{v[0] / length, v[1] / length, v[2] / length};
}

EightFloats magnitude(const EightFloats& a) {
  return max(a, EightFloats::all(0.0F) - a);
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
  const float slack = gap_slack(direction);
  return {direction, low - slack, high + slack};
}

unsigned SeparatingDirections::perhaps_meeting(const LeafTriangles& others, unsigned lanes) const {
  const EightCorners theirs = loaded(others);
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
