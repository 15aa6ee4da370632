#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/components.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Fills the holes of a mesh, sheets' too.
[[nodiscard]] inline PassRun fill(const Soup& soup,
                                  FillOptions options = {.sheets = FillSheets::Yes}) {
  return run_pass(soup, hole_filling(options));
}

/// Expects a closed, manifold, consistent mesh without intersections or degenerate faces.
inline void expect_filled(const Soup& soup) {
  const Analysis found = analyze(soup, "");
  EXPECT_EQ(found.attributes.closed.value, true);
  EXPECT_EQ(found.attributes.manifold.value, true);
  EXPECT_EQ(found.attributes.consistent.value, true);
  EXPECT_EQ(found.characteristics.intersecting_pairs, 0U);
  EXPECT_EQ(found.characteristics.zero_area_faces, 0U);
  EXPECT_EQ(found.integrity.degenerate_faces, 0U);
}

/// V - E + F.
[[nodiscard]] inline std::int64_t euler_characteristic(const Soup& soup) {
  const Analysis found = analyze(soup, "");
  const Characteristics& c = found.characteristics;
  return static_cast<std::int64_t>(c.vertices) - static_cast<std::int64_t>(c.edges) +
         static_cast<std::int64_t>(c.faces);
}

/// Tells whether all records of the input are still there bit for bit and in order: filling adds.
[[nodiscard]] inline bool keeps_input(const Soup& input, const TrackedMesh& tracked) {
  const Soup& soup = tracked.soup;
  if (soup.n_vertices() < input.n_vertices()) return false;
  const auto first = soup.positions.begin();
  const std::vector<Vec3> kept(first, first + static_cast<std::ptrdiff_t>(input.n_vertices()));
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < soup.n_faces(); ++i) {
    if (tracked.face_keys[i] < input.n_faces()) faces.push_back(soup.triangles[i]);
  }
  return same_bits(kept, input.positions) && faces == input.triangles;
}

[[nodiscard]] inline double area_of(const Soup& soup, const Triangle& t) {
  const Vec3& a = soup.positions[t[0]];
  return 0.5 * (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a).norm();
}

/// The area of all faces that fill holes.
[[nodiscard]] inline double area_of_patches(const TrackedMesh& tracked) {
  double area = 0.0;
  for (Index f = 0; f < tracked.soup.n_faces(); ++f) {
    if (tracked.origin_of_face(f) == kNoIndex)
      area += area_of(tracked.soup, tracked.soup.triangles[f]);
  }
  return area;
}

/// The wall of a prism without ends: over each polygon a ring of faces between z = 0 and z = 1,
/// seen from outside where the polygon runs counter-clockwise. Vertices 2 i and 2 i + 1 are the
/// lower and upper one of corner i, polygon after polygon.
[[nodiscard]] inline Soup prism_wall(
    const std::vector<std::vector<std::array<double, 2>>>& polygons) {
  Soup soup;
  for (const auto& polygon : polygons) {
    const auto first = static_cast<Index>(soup.n_vertices());
    const auto n = static_cast<Index>(polygon.size());
    for (const auto& [x, y] : polygon) {
      soup.positions.emplace_back(x, y, 0.0);
      soup.positions.emplace_back(x, y, 1.0);
    }
    for (Index i = 0; i < n; ++i) {
      const Index a = first + 2 * i;
      const Index b = first + 2 * ((i + 1) % n);
      soup.triangles.push_back({a, b, b + 1});
      soup.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return shapes::make(std::move(soup.positions), std::move(soup.triangles));
}

/// The area of a polygon, by Gauss's formula; negative where it runs clockwise.
[[nodiscard]] inline double polygon_area(const std::vector<std::array<double, 2>>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [x, y] = polygon[i];
    const auto& [u, v] = polygon[(i + 1) % polygon.size()];
    twice += x * v - u * y;
  }
  return 0.5 * twice;
}

/// A sphere that has lost connected patches of random size; what hung on nothing is gone too, so
/// that what is left is one piece.
[[nodiscard]] inline Soup punched(const Soup& closed, std::size_t n_patches, std::mt19937& random) {
  const auto n = static_cast<Index>(closed.n_faces());
  std::vector<std::uint8_t> is_gone(n, 0);
  for (std::size_t k = 0; k < n_patches; ++k) {
    std::vector<Index> patch{below(random, n)};
    const std::size_t size = 1 + below(random, n / 8);
    while (patch.size() < size) {
      // A neighbour by a common vertex of any face so far: ragged patches that touch themselves.
      const Triangle& t = closed.triangles[patch[below(random, static_cast<Index>(patch.size()))]];
      const Index v = t[below(random, 3)];
      for (Index f = 0; f < n; ++f) {
        const Triangle& u = closed.triangles[f];
        if (std::find(u.begin(), u.end(), v) != u.end() && below(random, 2) == 0) {
          patch.push_back(f);
        }
      }
    }
    for (const Index f : patch) is_gone[f] = 1;
  }
  std::vector<Index> gone;
  for (Index f = 0; f < n; ++f) {
    if (is_gone[f] != 0) gone.push_back(f);
  }
  Soup open = shapes::without_faces(closed, gone);
  const CutMesh cut = build(open);
  const Components pieces = find_edge_components(cut);
  std::vector<std::size_t> sizes(pieces.count, 0);
  for (const Index piece : pieces.of_face) ++sizes[piece];
  const auto largest =
      static_cast<Index>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::vector<Index> small;
  for (Index f = 0; f < open.n_faces(); ++f) {
    if (pieces.of_face[f] != largest) small.push_back(f);
  }
  return shapes::without_faces(std::move(open), small);
}

}  // namespace meshalyzer
