#include "meshalyzer/repair/facets/internal/facet_shape.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

FacetShape measure_of_usual_size(const Corners& p) {
  FacetShape shape;
  shape.lengths = side_lengths(p);
  const std::size_t longest = shape.longest_edge();
  // From the corner opposite to the longest edge, the differences are shortest.
  const Vec3 normal = accurate_normal(p, (longest + 2) % 3);
  const double twice_area = normal.norm();
  if (twice_area > 0.0) {
    shape.altitude = twice_area / shape.lengths[longest];
    shape.normal = normal / twice_area;
  }
  return shape;
}

}  // namespace

std::size_t FacetShape::longest_edge() const {
  return static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) -
                                  lengths.begin());
}

std::size_t FacetShape::shortest_edge() const {
  return static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) -
                                  lengths.begin());
}

FacetShape measure_facet(const Corners& p) {
  const std::array<double, 3> lengths = side_lengths(p);
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  if ((longest > 1e-100 && longest < 1e100) || longest == 0.0) return measure_of_usual_size(p);
  // Scaling by a power of two does not round here: no relevant coordinate is much smaller than the
  // longest edge, nor, being a double, much larger than it.
  const int exponent = length_exponent(longest);
  FacetShape shape = measure_of_usual_size(times_power_of_two(p, -exponent));
  for (double& length : shape.lengths) length = std::ldexp(length, exponent);
  shape.altitude = std::ldexp(shape.altitude, exponent);
  return shape;
}

}  // namespace meshalyzer
