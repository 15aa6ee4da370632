#include "support/shapes.h"

#include "support/constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <tuple>
#include <utility>

namespace meshalyzer::shapes {
namespace {

Index index(std::size_t i) {
  return static_cast<Index>(i);
}

/// Splits the quad a b c d along a-c.
void add_quad(std::vector<Triangle>& triangles, const std::array<Index, 4>& q) {
  triangles.push_back({q[0], q[1], q[2]});
  triangles.push_back({q[0], q[2], q[3]});
}

/// A point at `fraction` of a full turn round the z axis.
Vec3 on_circle(double fraction, double radius, double z) {
  return {radius * std::cos(2 * kPi * fraction), radius * std::sin(2 * kPi * fraction), z};
}

double ratio(std::size_t a, std::size_t b) {
  return static_cast<double>(a) / static_cast<double>(b);
}

/// The midpoint vertices of one subdivision, one for each edge.
class Midpoints {
 public:
  explicit Midpoints(std::vector<Vec3>& positions) : positions_(positions) {}

  Index of(Index a, Index b) {
    const auto [place, is_new] = known_.try_emplace(std::minmax(a, b), index(positions_.size()));
    if (is_new) {
      const Vec3 middle = positions_[a] + positions_[b];
      positions_.push_back(middle.normalized());
    }
    return place->second;
  }

 private:
  std::vector<Vec3>& positions_;
  std::map<std::pair<Index, Index>, Index> known_;
};

Soup icosahedron() {
  // Two poles and two rings of five at latitudes +-atan(1/2), the lower turned by a tenth of a
  // turn.
  const double z = 1.0 / std::sqrt(5.0);
  std::vector<Vec3> positions{{0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < 5; ++i) {
    positions.push_back(on_circle(ratio(i, 5), 2 * z, z));
    positions.push_back(on_circle(ratio(2 * i + 1, 10), 2 * z, -z));
    const Index upper = index(2 + 2 * i);
    const Index next_upper = index(2 + 2 * ((i + 1) % 5));
    triangles.push_back({0, upper, next_upper});
    triangles.push_back({upper, upper + 1, next_upper});
    triangles.push_back({upper + 1, next_upper + 1, next_upper});
    triangles.push_back({1, next_upper + 1, upper + 1});
  }
  return make(std::move(positions), std::move(triangles));
}

/// The surface of a set of unit cubes, given by a function of three signed cell numbers.
template <typename IsSolid>
Soup voxel_surface(const std::array<int, 3>& size, const IsSolid& is_solid) {
  Soup soup;
  std::map<std::array<int, 3>, Index> known;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = known.try_emplace(at, index(soup.positions.size()));
    if (is_new) soup.positions.emplace_back(at[0], at[1], at[2]);
    return place->second;
  };
  const auto add_sides = [&](const std::array<int, 3>& cell, std::size_t axis) {
    for (const int side : {0, 1}) {
      std::array<int, 3> neighbour = cell;
      neighbour[axis] += 2 * side - 1;
      if (is_solid(neighbour)) continue;
      std::array<Index, 4> quad{};
      // Counter-clockwise seen from the positive end of the axis; turned on the other side.
      for (std::size_t k = 0; k < 4; ++k) {
        std::array<int, 3> corner = cell;
        corner[axis] += side;
        corner[(axis + 1) % 3] += (k == 1 || k == 2) ? 1 : 0;
        corner[(axis + 2) % 3] += (k >= 2) ? 1 : 0;
        quad[side == 1 ? k : 3 - k] = vertex(corner);
      }
      add_quad(soup.triangles, quad);
    }
  };
  for (int x = 0; x < size[0]; ++x) {
    for (int y = 0; y < size[1]; ++y) {
      for (int z = 0; z < size[2]; ++z) {
        if (!is_solid({x, y, z})) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) add_sides({x, y, z}, axis);
      }
    }
  }
  return soup;
}

}  // namespace

Soup make(std::vector<Vec3> positions, std::vector<Triangle> triangles) {
  Soup soup;
  soup.positions = std::move(positions);
  soup.triangles = std::move(triangles);
  return soup;
}

Soup tetrahedron() {
  return make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

Soup cube(double side, const Vec3& corner) {
  // Vertex i is at (bit 0, bit 1, bit 2) of i.
  Soup soup;
  for (int i = 0; i < 8; ++i) {
    soup.positions.emplace_back(corner + side * Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  }
  const std::array<std::array<Index, 4>, 6> quads{
      {{0, 2, 3, 1}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}, {4, 5, 7, 6}}};
  for (const auto& quad : quads) add_quad(soup.triangles, quad);
  return soup;
}

Soup box(const Vec3& low, const Vec3& high) {
  Soup soup = cube();
  for (Vec3& p : soup.positions) p = low + p.cwiseProduct(high - low);
  return soup;
}

Soup open_cube() {
  Soup soup = cube();
  soup.triangles.resize(10);
  return soup;
}

Soup uv_sphere(std::size_t n_lat, std::size_t n_lon) {
  Soup soup;
  for (std::size_t i = 1; i < n_lat; ++i) {
    const double polar = kPi * ratio(i, n_lat);
    for (std::size_t j = 0; j < n_lon; ++j) {
      soup.positions.push_back(on_circle(ratio(j, n_lon), std::sin(polar), std::cos(polar)));
    }
  }
  const Index north = index(soup.positions.size());
  const Index south = north + 1;
  soup.positions.emplace_back(0, 0, 1);
  soup.positions.emplace_back(0, 0, -1);
  const auto at = [&](std::size_t ring, std::size_t j) { return index(ring * n_lon + j % n_lon); };
  for (std::size_t j = 0; j < n_lon; ++j) {
    soup.triangles.push_back({north, at(0, j), at(0, j + 1)});
    for (std::size_t ring = 0; ring + 2 < n_lat; ++ring) {
      add_quad(soup.triangles,
               {at(ring, j), at(ring + 1, j), at(ring + 1, j + 1), at(ring, j + 1)});
    }
    soup.triangles.push_back({south, at(n_lat - 2, j + 1), at(n_lat - 2, j)});
  }
  return soup;
}

Soup icosphere(std::size_t level) {
  Soup soup = icosahedron();
  for (std::size_t step = 0; step < level; ++step) {
    Midpoints midpoints(soup.positions);
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : soup.triangles) {
      const Index ab = midpoints.of(a, b);
      const Index bc = midpoints.of(b, c);
      const Index ca = midpoints.of(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    soup.triangles = std::move(finer);
  }
  return soup;
}

Soup torus(double R, double r, std::size_t nu, std::size_t nv) {
  Soup soup;
  for (std::size_t i = 0; i < nu; ++i) {
    for (std::size_t j = 0; j < nv; ++j) {
      const double tube = 2 * kPi * ratio(j, nv);
      soup.positions.push_back(on_circle(ratio(i, nu), R + r * std::cos(tube), r * std::sin(tube)));
    }
  }
  const auto at = [&](std::size_t i, std::size_t j) { return index((i % nu) * nv + j % nv); };
  for (std::size_t i = 0; i < nu; ++i) {
    for (std::size_t j = 0; j < nv; ++j) {
      add_quad(soup.triangles, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

Soup genus_block(std::size_t n) {
  const std::array<int, 3> size{static_cast<int>(2 * n + 1), 3, 1};
  return voxel_surface(size, [&](const std::array<int, 3>& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell[axis] < 0 || cell[axis] >= size[axis]) return false;
    }
    return !(cell[0] % 2 == 1 && cell[1] == 1);
  });
}

Soup moebius_strip(std::size_t n) {
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const double twist = kPi * ratio(i, n);
    for (const double side : {-0.5, 0.5}) {
      soup.positions.push_back(
          on_circle(ratio(i, n), 2 + side * std::cos(twist), side * std::sin(twist)));
    }
  }
  // After a full turn the two rails change places.
  const auto at = [&](std::size_t i, std::size_t rail) {
    return i < n ? index(2 * i + rail) : index(1 - rail);
  };
  for (std::size_t i = 0; i < n; ++i) {
    add_quad(soup.triangles, {at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)});
  }
  return soup;
}

Soup projective_plane() {
  // The icosahedron with opposite points made one: a pole and a ring of five.
  Soup soup;
  soup.positions.emplace_back(0, 0, 1);
  for (std::size_t i = 0; i < 5; ++i) {
    soup.positions.push_back(on_circle(ratio(i, 5), 1.0, 0.1 * static_cast<double>(i * i)));
    const auto ring = [&](std::size_t k) { return index(1 + (i + k) % 5); };
    soup.triangles.push_back({0, ring(0), ring(1)});
    soup.triangles.push_back({ring(0), ring(1), ring(3)});
  }
  return soup;
}

Soup klein_bottle(std::size_t nu, std::size_t nv) {
  Soup soup = torus(3.0, 1.0, nu, nv);
  soup.triangles.clear();
  // A torus whose tube is glued to itself mirrored.
  const auto at = [&](std::size_t i, std::size_t j) {
    return i < nu ? index(i * nv + j % nv) : index((nv - j % nv) % nv);
  };
  for (std::size_t i = 0; i < nu; ++i) {
    for (std::size_t j = 0; j < nv; ++j) {
      add_quad(soup.triangles, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

Soup two_tetrahedra_sharing_vertex() {
  // The second is the first, mirrored through the origin and so turned over.
  return make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}});
}

Soup two_tetrahedra_sharing_edge() {
  // The second is the first, turned by half a turn about the z axis.
  return make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 5, 4}, {0, 4, 3}, {0, 3, 5}, {4, 5, 3}});
}

Soup two_tetrahedra_sharing_face() {
  // The second is the first mirrored in the plane z = 0.
  return make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 2}, {0, 4, 1}, {0, 2, 4}, {1, 4, 2}});
}

Soup nested_cubes(InnerShell inner) {
  const Soup small = cube(1.0, Vec3::Ones());
  return merged(cube(3.0), inner == InnerShell::Outward ? small : flipped(small));
}

Soup pillow() {
  return make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
}

Soup fan_of_three() {
  return make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
              {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
}

Soup grid(std::size_t nx, std::size_t ny) {
  Soup soup;
  for (std::size_t j = 0; j <= ny; ++j) {
    for (std::size_t i = 0; i <= nx; ++i) {
      soup.positions.emplace_back(static_cast<double>(i), static_cast<double>(j), 0.0);
    }
  }
  const auto at = [&](std::size_t i, std::size_t j) { return index(j * (nx + 1) + i); };
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      add_quad(soup.triangles, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

Soup merged(Soup a, const Soup& b) {
  const Index offset = index(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (Triangle t : b.triangles) {
    for (Index& corner : t) {
      if (corner != kNoIndex) corner += offset;
    }
    a.triangles.push_back(t);
  }
  return a;
}

Soup translated(Soup soup, const Vec3& by) {
  for (Vec3& p : soup.positions) p += by;
  return soup;
}

Soup scaled(Soup soup, double factor) {
  for (Vec3& p : soup.positions) p *= factor;
  return soup;
}

Soup flipped(Soup soup) {
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

Soup flipped(Soup soup, std::span<const Index> faces) {
  for (const Index f : faces) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
  return soup;
}

Soup without_faces(Soup soup, std::span<const Index> faces) {
  std::vector<Triangle> kept;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const bool is_out = std::find(faces.begin(), faces.end(), index(f)) != faces.end();
    if (!is_out) kept.push_back(soup.triangles[f]);
  }
  soup.triangles = std::move(kept);
  return soup;
}

Soup shuffled_faces(Soup soup, std::uint32_t seed) {
  const std::vector<Index> place = permutation(soup.triangles.size(), seed);
  std::vector<Triangle> shuffled(place.size());
  for (std::size_t f = 0; f < place.size(); ++f) {
    Triangle t = soup.triangles[f];
    std::rotate(t.begin(), t.begin() + place[f] % 3, t.end());
    shuffled[place[f]] = t;
  }
  soup.triangles = std::move(shuffled);
  return soup;
}

Soup tangle(std::size_t n) {
  std::mt19937 random(1);
  const auto coordinate = [&] { return static_cast<double>(random()) / 0x1p32; };
  Soup soup;
  for (std::size_t v = 0; v < 3 * n; ++v) {
    const double x = coordinate();
    const double y = coordinate();
    soup.positions.emplace_back(x, y, coordinate());
    if (v % 3 == 2) soup.triangles.push_back({index(v - 2), index(v - 1), index(v)});
  }
  return soup;
}

std::vector<Index> permutation(std::size_t n, std::uint32_t seed) {
  // This shuffles by hand, because the standard's shuffle and distributions differ between
  // libraries.
  std::mt19937 random(seed);
  std::vector<Index> place(n);
  for (std::size_t i = 0; i < n; ++i) {
    place[i] = index(i);
    std::swap(place[i], place[random() % (i + 1)]);
  }
  return place;
}

Soup renumbered_vertices(Soup soup, std::uint32_t seed) {
  const std::vector<Index> place = permutation(soup.positions.size(), seed);
  const std::vector<Vec3> old = soup.positions;
  for (std::size_t i = 0; i < place.size(); ++i) soup.positions[place[i]] = old[i];
  for (Triangle& t : soup.triangles) {
    for (Index& corner : t) {
      if (corner != kNoIndex) corner = place[corner];
    }
  }
  return soup;
}

}  // namespace meshalyzer::shapes
