#include "big_meshes.h"

#include "damage.h"
#include "meshalyzer/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <unordered_map>
#include <utility>

namespace meshalyzer::bench {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Joins the points of a grid that closes on itself in both directions, outward for a torus walked
/// ring by ring.
void close_grid(Soup& soup, std::size_t rings, std::size_t spokes) {
  const std::size_t first = soup.n_vertices() - rings * spokes;
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<Index>(first + (i % rings) * spokes + j % spokes);
  };
  for (std::size_t i = 0; i < rings; ++i) {
    for (std::size_t j = 0; j < spokes; ++j) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

void add_wavy_torus(Soup& soup, std::size_t faces, const Vec3& centre) {
  const auto spokes = static_cast<std::size_t>(std::sqrt(static_cast<double>(faces) / 6)) + 3;
  const std::size_t rings = faces / (2 * spokes) + 3;
  for (std::size_t i = 0; i < rings; ++i) {
    const double u = kTurn * static_cast<double>(i) / static_cast<double>(rings);
    for (std::size_t j = 0; j < spokes; ++j) {
      const double v = kTurn * static_cast<double>(j) / static_cast<double>(spokes);
      const double r = 1.0 + 0.1 * std::sin(9 * u) * std::cos(7 * v);
      soup.positions.push_back(centre + Vec3((3 + r * std::cos(v)) * std::cos(u),
                                             (3 + r * std::cos(v)) * std::sin(u), r * std::sin(v)));
    }
  }
  close_grid(soup, rings, spokes);
}

/// A side of a box as a grid of n by n squares; corners shared by position are merged by weld().
void add_side(Soup& soup, const std::array<Vec3, 3>& frame, std::size_t n) {
  const auto first = static_cast<Index>(soup.n_vertices());
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<Index>(first + i * (n + 1) + j);
  };
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      soup.positions.push_back(frame[0] + frame[1] * static_cast<double>(i) +
                               frame[2] * static_cast<double>(j));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

/// Makes bit-identical points one vertex.
void weld(Soup& soup) {
  std::vector<Index> order(soup.n_vertices());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = static_cast<Index>(i);
  }
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return less(soup.positions[a], soup.positions[b]); });
  std::vector<Index> merged(soup.n_vertices());
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || soup.positions[order[i]] != positions.back()) {
      positions.push_back(soup.positions[order[i]]);
    }
    merged[order[i]] = static_cast<Index>(positions.size() - 1);
  }
  soup.positions = std::move(positions);
  for (Triangle& t : soup.triangles) {
    t = {merged[t[0]], merged[t[1]], merged[t[2]]};
  }
}

void add_flat_cube(Soup& soup, std::size_t faces) {
  const auto n = static_cast<std::size_t>(std::sqrt(static_cast<double>(faces) / 12)) + 1;
  const auto s = static_cast<double>(n);
  const Vec3 x(1, 0, 0);
  const Vec3 y(0, 1, 0);
  const Vec3 z(0, 0, 1);
  const std::array<std::array<Vec3, 3>, 6> sides{{{Vec3(0, 0, 0), y, x},
                                                  {Vec3(0, 0, s), x, y},
                                                  {Vec3(0, 0, 0), x, z},
                                                  {Vec3(0, s, 0), z, x},
                                                  {Vec3(0, 0, 0), z, y},
                                                  {Vec3(s, 0, 0), y, z}}};
  for (const auto& side : sides) {
    add_side(soup, side, n);
  }
  weld(soup);
}

/// Splits each face in four at the middles of its edges.
Soup subdivided(const Soup& soup) {
  Soup fine;
  fine.positions = soup.positions;
  std::unordered_map<std::uint64_t, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
    const auto [entry, is_new] = middles.try_emplace(key, static_cast<Index>(fine.n_vertices()));
    if (is_new) {
      fine.positions.emplace_back((soup.positions[a] + soup.positions[b]) / 2);
    }
    return entry->second;
  };
  for (const Triangle& t : soup.triangles) {
    const Triangle m{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    fine.triangles.insert(fine.triangles.end(),
                          {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, m});
  }
  return fine;
}

/// A cylinder of height 1 and radius 1 whose caps are fans round one vertex of their rim.
void add_bolt(Soup& soup, std::size_t spokes, const Vec3& centre) {
  const auto first = static_cast<Index>(soup.n_vertices());
  const auto n = static_cast<Index>(spokes);
  const Eigen::AngleAxisd askew(0.7, Vec3(0.3, 0.8, 0.52).normalized());
  for (std::size_t i = 0; i < 2 * spokes; ++i) {
    const double angle = kTurn * static_cast<double>(i % spokes) / static_cast<double>(spokes);
    const Vec3 p(std::cos(angle), std::sin(angle), i < spokes ? 0.0 : 1.0);
    soup.positions.emplace_back(askew * (centre + p));
  }
  for (Index i = 0; i < n; ++i) {
    const Index a = first + i;
    const Index b = first + (i + 1) % n;
    soup.triangles.push_back({a, b, b + n});
    soup.triangles.push_back({a, b + n, a + n});
    if (i > 0 && i + 1 < n) {
      soup.triangles.push_back({first, b, a});
      soup.triangles.push_back({first + n, a + n, b + n});
    }
  }
}

void add_bolts(Soup& soup, std::size_t faces) {
  constexpr std::size_t kBolts = 24;
  for (std::size_t i = 0; i < kBolts; ++i) {
    add_bolt(soup, faces / (4 * kBolts) + 3,
             3 * Vec3(static_cast<double>(i % 6), static_cast<double>(i / 6), 0.0));
  }
}

void add_sliver_tube(Soup& soup, std::size_t faces) {
  const std::size_t spokes = faces / 2;
  const Vec3 along = Vec3(1, 1.1, 0.9) * 10;
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.normalized().cross(u);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < spokes; ++j) {
      const double angle = kTurn * static_cast<double>(j) / static_cast<double>(spokes);
      soup.positions.push_back(along * static_cast<double>(i) + std::cos(angle) * u +
                               std::sin(angle) * v);
    }
  }
  close_grid(soup, 2, spokes);
  soup.triangles.resize(soup.triangles.size() /
                        2);  // the second ring does not go back to the first
}

/// A beam of three edges along a diagonal of space, closed. Two of its edges are arched and have a
/// vertex every unit of length, a strip between them; the third has its ends only, so that the
/// walls beside it are fans round its first end.
void add_beam(Soup& soup, std::size_t faces) {
  const std::size_t steps = std::max<std::size_t>(1, faces / 4);
  const auto length = static_cast<double>(steps);
  const Vec3 along = Vec3(1, 1.1, 0.9).normalized();
  const Vec3 up = along.unitOrthogonal();
  const Vec3 aside = along.cross(up);
  for (std::size_t i = 0; i <= steps; ++i) {
    const double x = static_cast<double>(i);
    const double height = 10 + 0.02 * x * (length - x) / length;
    soup.positions.emplace_back(x * along + height * up - 5 * aside);
    soup.positions.emplace_back(x * along + height * up + 5 * aside);
  }
  const auto first = static_cast<Index>(soup.n_vertices());
  soup.positions.insert(soup.positions.end(), {Vec3(0, 0, 0), length * along});
  for (Index i = 0; i < 2 * steps; i += 2) {
    soup.triangles.push_back({i, i + 1, i + 2});
    soup.triangles.push_back({i + 1, i + 3, i + 2});
    soup.triangles.push_back({first, i, i + 2});
    soup.triangles.push_back({first, i + 3, i + 1});
  }
  const auto last = static_cast<Index>(2 * steps);
  soup.triangles.insert(soup.triangles.end(), {{first, 1, 0},
                                               {first, last, first + 1},
                                               {first, first + 1, last + 1},
                                               {first + 1, last, last + 1}});
}

void add_fan(Soup& soup, std::size_t faces) {
  const std::size_t n = faces / 2;
  soup.positions = {Vec3(0, 0, 0.1), Vec3(0, 0, -0.1)};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = kTurn * static_cast<double>(i) / static_cast<double>(n);
    soup.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto a = static_cast<Index>(2 + i);
    const auto b = static_cast<Index>(2 + (i + 1) % n);
    soup.triangles.push_back({0, a, b});
    soup.triangles.push_back({1, b, a});
  }
}

void add_onion(Soup& soup, std::size_t faces) {
  for (std::size_t shell = 0; shell < std::max<std::size_t>(1, faces / 12); ++shell) {
    Soup cube;
    add_flat_cube(cube, 1);
    const double half = 1.0 + static_cast<double>(shell);
    for (const Vec3& p : cube.positions) {
      soup.positions.push_back((2 * p - Vec3::Ones()) * half);
    }
    const auto first = static_cast<Index>(soup.n_vertices() - cube.n_vertices());
    for (const Triangle& t : cube.triangles) {
      const Triangle moved{t[0] + first, t[1] + first, t[2] + first};
      soup.triangles.push_back(shell % 2 == 0 ? moved : Triangle{moved[0], moved[2], moved[1]});
    }
  }
}

void add_shards(Soup& soup, std::size_t faces) {
  const auto side = static_cast<std::size_t>(std::cbrt(static_cast<double>(faces))) + 1;
  for (std::size_t i = 0; i < faces; ++i) {
    const Vec3 corner(static_cast<double>(i % side), static_cast<double>(i / side % side),
                      static_cast<double>(i / side / side));
    const auto first = static_cast<Index>(soup.n_vertices());
    soup.positions.insert(soup.positions.end(),
                          {corner, corner + Vec3(0.5, 0.1, 0.2), corner + Vec3(0.1, 0.6, 0.3)});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
}

void add_orphans(Soup& soup, std::size_t orphans) {
  soup.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (std::size_t i = 0; i < orphans; ++i) {
    soup.positions.emplace_back(static_cast<double>(i % 1000), static_cast<double>(i / 1000 % 1000),
                                2.0 + static_cast<double>(i / 1000000));
  }
}

void add_tangle(Soup& soup, std::size_t faces) {
  std::mt19937 random(1);
  const auto coordinate = [&] { return static_cast<double>(random()) / 0x1p32; };
  for (std::size_t i = 0; i < faces; ++i) {
    const auto first = static_cast<Index>(soup.n_vertices());
    for (int corner = 0; corner < 3; ++corner) {
      const double x = coordinate();
      const double y = coordinate();
      soup.positions.emplace_back(x, y, coordinate());
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
}

/// Any order of n things, the same each time. Not std::shuffle, which differs between libraries.
std::vector<Index> shuffled_numbers(std::size_t n, std::mt19937& random) {
  std::vector<Index> numbers(n);
  std::iota(numbers.begin(), numbers.end(), Index{0});
  for (std::size_t i = n; i > 1; --i) std::swap(numbers[i - 1], numbers[random() % i]);
  return numbers;
}

Soup shuffled(const Soup& soup) {
  std::mt19937 random(1);
  const std::vector<Index> vertex = shuffled_numbers(soup.n_vertices(), random);
  const std::vector<Index> face = shuffled_numbers(soup.n_faces(), random);
  Soup result = soup;
  for (std::size_t v = 0; v < vertex.size(); ++v) result.positions[vertex[v]] = soup.positions[v];
  for (std::size_t f = 0; f < face.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    result.triangles[face[f]] = {vertex[t[0]], vertex[t[1]], vertex[t[2]]};
  }
  return result;
}

}  // namespace

Soup big_mesh(std::string_view kind, std::size_t faces) {
  Soup soup;
  if (kind == "wavy") {
    add_wavy_torus(soup, faces, Vec3::Zero());
  } else if (kind == "damaged") {
    add_wavy_torus(soup, faces, Vec3::Zero());
    soup = damaged(std::move(soup), std::min<std::size_t>(1000, 1 + faces / 100));
  } else if (kind == "shuffled") {
    add_wavy_torus(soup, faces, Vec3::Zero());
    soup = shuffled(soup);
  } else if (kind == "flat") {
    add_flat_cube(soup, faces);
  } else if (kind == "subdivided") {
    add_wavy_torus(soup, faces / 16, Vec3::Zero());
    soup = subdivided(subdivided(soup));
  } else if (kind == "cad") {
    add_bolts(soup, faces);
  } else if (kind == "slivers") {
    add_sliver_tube(soup, faces);
  } else if (kind == "beam") {
    add_beam(soup, faces);
  } else if (kind == "crossing") {
    add_wavy_torus(soup, faces / 2, Vec3::Zero());
    add_wavy_torus(soup, faces / 2, Vec3(1.5, 0.3, 0.4));
  } else if (kind == "fan") {
    add_fan(soup, faces);
  } else if (kind == "onion") {
    add_onion(soup, faces);
  } else if (kind == "shards") {
    add_shards(soup, faces);
  } else if (kind == "orphans") {
    add_orphans(soup, faces);
  } else if (kind == "tangle") {
    add_tangle(soup, faces);
  } else {
    throw InvalidArgument("no such mesh: " + std::string(kind));
  }
  return soup;
}

}  // namespace meshalyzer::bench
