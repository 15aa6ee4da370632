#include "meshalyzer/arrangement/face_simplex.h"

#include "meshalyzer/base/lexicographic.h"

#include <algorithm>

namespace meshalyzer {
namespace {

bool has_corner(const FaceSimplex& simplex, Index x) {
  return std::find(simplex.vertices.begin(), simplex.vertices.end(), x) != simplex.vertices.end();
}

/// Tells whether a point in the plane of the triangle lies in the triangle.
bool is_in_triangle(const Soup& soup, const FaceSimplex& simplex, Index x) {
  const auto at = [&](std::size_t i) -> const Vec3& {
    return soup.positions[simplex.vertices[i % 3]];
  };
  const Sign turn = orient2d(simplex.axis, at(0), at(1), at(2));
  for (std::size_t i = 0; i < 3; ++i) {
    if (orient2d(simplex.axis, at(i), at(i + 1), soup.positions[x]) * turn < 0) return false;
  }
  return true;
}

}  // namespace

std::vector<VertexPair> FaceSimplex::edges() const {
  if (dimension == 2) {
    return {{vertices[0], vertices[1]}, {vertices[1], vertices[2]}, {vertices[2], vertices[0]}};
  }
  if (dimension == 1) return {ends};
  return {};
}

FaceSimplex face_simplex(const Soup& soup, Index face) {
  const Triangle& t = soup.triangles[face];
  FaceSimplex simplex{.face = face, .vertices = t};
  const auto at = [&](Index v) -> const Vec3& { return soup.positions[v]; };
  if (const auto axis = projection_axis(at(t[0]), at(t[1]), at(t[2]))) {
    simplex.axis = *axis;
    return simplex;
  }
  const auto [low, high] = std::minmax_element(
      t.begin(), t.end(), [&](Index a, Index b) { return lexicographically_less(at(a), at(b)); });
  simplex.ends = {*low, *high};
  simplex.dimension = at(*low) == at(*high) ? 0 : 1;
  return simplex;
}

bool is_on_segment(const Soup& soup, const VertexPair& ends, Index x) {
  if (x == ends[0] || x == ends[1]) return true;
  const Vec3& point = soup.positions[x];
  const auto [low, high] =
      std::minmax(soup.positions[ends[0]], soup.positions[ends[1]], lexicographically_less);
  return !lexicographically_less(point, low) && !lexicographically_less(high, point) &&
         are_collinear(low, high, point);
}

bool contains(const Soup& soup, const FaceSimplex& simplex, Index x) {
  if (has_corner(simplex, x)) return true;
  switch (simplex.dimension) {
    case 2:
      return side_of(soup, simplex, x) == 0 && is_in_triangle(soup, simplex, x);
    case 1:
      return is_on_segment(soup, simplex.ends, x);
    default:
      return soup.positions[x] == soup.positions[simplex.vertices[0]];
  }
}

Sign side_of(const Soup& soup, const FaceSimplex& triangle, Index x) {
  if (has_corner(triangle, x)) return 0;
  const auto [a, b, c] = triangle.vertices;
  return orient3d(soup.positions[a], soup.positions[b], soup.positions[c], soup.positions[x]);
}

}  // namespace meshalyzer
