#include "random_damage.h"

#include "support/random_soups.h"
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Far below the degeneracy and slit tolerance of a mesh of some units: 1e-8 of the diagonal.
constexpr double kTinyShare = 1e-10;

/// A number in -1 ... 1, a multiple of 1/1024.
double any_number(std::mt19937& random) {
  return (static_cast<double>(below(random, 2049)) - 1024.0) / 1024.0;
}

Vec3 any_vector(std::mt19937& random) {
  const double x = any_number(random);
  const double y = any_number(random);
  return {x, y, any_number(random)};
}

/// A face of the complex; the shapes have so many that one is soon found.
Index any_face(const Soup& soup, std::mt19937& random) {
  while (true) {
    const Index face = below(random, static_cast<Index>(soup.n_faces()));
    if (is_in_complex(soup.triangles[face])) return face;
  }
}

Index add_vertex(Soup& soup, const Vec3& position) {
  soup.positions.push_back(position);
  return static_cast<Index>(soup.n_vertices() - 1);
}

bool has_vertex(const Triangle& t, Index v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

/// Drops faces, unless nothing would be left; what is said of missing vertices follows the others.
template <typename Goes>
void drop_faces(Soup& soup, Goes&& goes) {
  const auto stays = [&](const Triangle& t) {
    return is_in_complex(t) && !goes(static_cast<Index>(&t - soup.triangles.data()));
  };
  if (std::none_of(soup.triangles.begin(), soup.triangles.end(), stays)) return;
  std::vector<Triangle> kept;
  std::vector<MissingReference> missing;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (is_in_complex(soup.triangles[f]) && goes(f)) continue;
    for (MissingReference reference : soup.missing) {
      if (reference.face != f) continue;
      reference.face = static_cast<Index>(kept.size());
      missing.push_back(reference);
    }
    kept.push_back(soup.triangles[f]);
  }
  soup.triangles = std::move(kept);
  soup.missing = std::move(missing);
}

// The kinds of damage.

void lose_face(Soup& soup, std::mt19937& random) {
  const Index gone = any_face(soup, random);
  drop_faces(soup, [&](Index f) { return f == gone; });
}

void lose_star(Soup& soup, std::mt19937& random) {
  const Index v = soup.triangles[any_face(soup, random)][0];
  drop_faces(soup, [&](Index f) { return has_vertex(soup.triangles[f], v); });
}

void turn_faces(Soup& soup, std::mt19937& random) {
  for (Index n = 1 + below(random, 4); n > 0; --n) {
    Triangle& t = soup.triangles[any_face(soup, random)];
    std::swap(t[1], t[2]);
  }
}

void turn_all(Soup& soup, std::mt19937& /*random*/) {
  for (Triangle& t : soup.triangles) {
    if (is_in_complex(t)) std::swap(t[1], t[2]);
  }
}

void repeat_face(Soup& soup, std::mt19937& random) {
  Triangle t = soup.triangles[any_face(soup, random)];
  std::rotate(t.begin(), t.begin() + below(random, 3), t.end());
  if (below(random, 2) == 0) std::swap(t[1], t[2]);
  soup.triangles.push_back(t);
}

/// Splits an edge, in all its faces, right beside one of its ends.
void add_needle(Soup& soup, std::mt19937& random) {
  const Triangle face = soup.triangles[any_face(soup, random)];
  const Index a = face[0];
  const Index b = face[1];
  const double share = kTinyShare * below(random, 3);
  const Index m =
      add_vertex(soup, soup.positions[a] + share * (soup.positions[b] - soup.positions[a]));
  const std::size_t n = soup.n_faces();
  for (std::size_t f = 0; f < n; ++f) {
    Triangle& t = soup.triangles[f];
    if (!is_in_complex(t) || !has_vertex(t, a) || !has_vertex(t, b)) continue;
    Triangle other = t;
    std::replace(t.begin(), t.end(), a, m);
    std::replace(other.begin(), other.end(), b, m);
    soup.triangles.push_back(other);
  }
}

/// Splits a face right beside, or on, the middle of one of its edges.
void add_cap(Soup& soup, std::mt19937& random) {
  const Index face = any_face(soup, random);
  const auto [a, b, c] = soup.triangles[face];
  const Vec3 middle = 0.5 * (soup.positions[a] + soup.positions[b]);
  const double share = kTinyShare * below(random, 3);
  const Index m = add_vertex(soup, middle + share * (soup.positions[c] - middle));
  soup.triangles[face] = {a, b, m};
  soup.triangles.push_back({b, c, m});
  soup.triangles.push_back({c, a, m});
}

/// A face gets a copy of one, two or all of its vertices, some of them not quite in place.
void loosen_face(Soup& soup, std::mt19937& random) {
  const Index face = any_face(soup, random);
  const Index n = 1 + below(random, 3);
  const double amount = kTinyShare * below(random, 3);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 place = soup.positions[soup.triangles[face][k]] + amount * any_vector(random);
    soup.triangles[face][k] = add_vertex(soup, place);
  }
}

/// Cuts the mesh in two along a plane.
void open_seam(Soup& soup, std::mt19937& random) {
  const Vec3 normal = any_vector(random);
  const Vec3 through = soup.positions[soup.triangles[any_face(soup, random)][0]];
  const double amount = kTinyShare * below(random, 3);
  std::vector<std::uint8_t> is_near(soup.n_vertices(), 0);
  std::vector<Index> far_faces;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (!is_in_complex(t)) continue;
    const Vec3 sum = soup.positions[t[0]] + soup.positions[t[1]] + soup.positions[t[2]];
    if (normal.dot(sum - 3 * through) > 0) {
      far_faces.push_back(f);
    } else {
      for (const Index v : t) is_near[v] = 1;
    }
  }
  std::vector<Index> copy(soup.n_vertices(), kNoIndex);
  for (const Index f : far_faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = soup.triangles[f][k];
      if (is_near[v] == 0) continue;
      if (copy[v] == kNoIndex) {
        copy[v] = add_vertex(soup, soup.positions[v] + amount * any_vector(random));
      }
      soup.triangles[f][k] = copy[v];
    }
  }
}

/// Hangs a small octahedron on the vertex with the largest x.
void hang_on_vertex(Soup& soup, std::mt19937& random) {
  Index last = soup.triangles[any_face(soup, random)][0];
  for (const Triangle& t : soup.triangles) {
    for (const Index v : t) {
      if (v != kNoIndex && soup.positions[v].x() > soup.positions[last].x()) last = v;
    }
  }
  const auto first = static_cast<Index>(soup.n_vertices());
  Soup small = shapes::scaled(shapes::uv_sphere(2, 4), 0.25);
  const auto touching =
      std::min_element(small.positions.begin(), small.positions.end(),
                       [](const Vec3& p, const Vec3& q) { return p.x() < q.x(); });
  const auto replaced = static_cast<Index>(touching - small.positions.begin());
  small = shapes::translated(std::move(small), soup.positions[last] - *touching);
  for (const Vec3& p : small.positions) soup.positions.push_back(p);
  // One vertex of it stays behind as an orphan.
  for (Triangle t : small.triangles) {
    for (Index& v : t) v = v == replaced ? last : first + v;
    soup.triangles.push_back(t);
  }
}

/// Sets a small tetrahedron, or one face of it, on an edge, outside.
void hang_on_edge(Soup& soup, std::mt19937& random) {
  const auto [a, b, c] = soup.triangles[any_face(soup, random)];
  const Vec3& p = soup.positions[a];
  const Vec3 along = soup.positions[b] - p;
  const Vec3 normal = along.cross(soup.positions[c] - p).normalized() * along.norm();
  const Vec3 across = normal.cross(along).normalized() * along.norm();
  const Vec3 middle = p + 0.5 * along + 0.125 * normal;
  const Index d = add_vertex(soup, middle + 0.03125 * across);
  const Index e = add_vertex(soup, middle - 0.03125 * across);
  soup.triangles.push_back({a, b, d});
  if (below(random, 2) == 0) return;
  soup.triangles.push_back({b, a, e});
  soup.triangles.push_back({a, d, e});
  soup.triangles.push_back({b, e, d});
}

void add_orphan(Soup& soup, std::mt19937& random) {
  add_vertex(soup, any_vector(random));
}

void add_false_record(Soup& soup, std::mt19937& random) {
  const Triangle t = soup.triangles[any_face(soup, random)];
  const auto face = static_cast<Index>(soup.n_faces());
  if (below(random, 2) == 0) {
    soup.triangles.push_back({t[0], t[0], t[1]});
  } else {
    soup.triangles.push_back({t[0], t[1], kNoIndex});
    soup.missing.push_back({face, 2, std::int64_t{1} << 40});
  }
}

/// Pulls a vertex out of its place: neighbours may fold over or cross.
void pull_vertex(Soup& soup, std::mt19937& random) {
  const auto [a, b, c] = soup.triangles[any_face(soup, random)];
  const Vec3 middle = 0.5 * (soup.positions[b] + soup.positions[c]);
  soup.positions[a] += (1.0 + 0.25 * any_number(random)) * (middle - soup.positions[a]);
}

void give_second_solid(Soup& soup, std::mt19937& random) {
  const std::array<Soup, 4> solids{shapes::two_tetrahedra_sharing_face(),
                                   shapes::two_tetrahedra_sharing_edge(),
                                   shapes::two_tetrahedra_sharing_vertex(), shapes::open_cube()};
  soup =
      shapes::merged(std::move(soup), shapes::translated(solids[below(random, 4)], Vec3(20, 0, 0)));
}

struct Damage {
  std::string_view name;
  void (*make)(Soup&, std::mt19937&);
};

constexpr std::array<Damage, 15> kDamages{{{"lost face", lose_face},
                                           {"lost star", lose_star},
                                           {"turned faces", turn_faces},
                                           {"all turned", turn_all},
                                           {"repeated face", repeat_face},
                                           {"needle", add_needle},
                                           {"cap", add_cap},
                                           {"loose face", loosen_face},
                                           {"seam", open_seam},
                                           {"solid on a vertex", hang_on_vertex},
                                           {"hung on an edge", hang_on_edge},
                                           {"orphan", add_orphan},
                                           {"false record", add_false_record},
                                           {"pulled vertex", pull_vertex},
                                           {"second solid", give_second_solid}}};

/// What else files say: names of ids with gaps and repeats, groups, normals, some of them opposed.
void dress_up(Soup& soup, std::mt19937& random) {
  switch (below(random, 4)) {
    case 0:
      for (Index f = 0; f < soup.n_faces(); ++f) {
        soup.face_ids.named.push_back(
            static_cast<std::int32_t>(below(random, 50) == 0 ? 7 : 2 * f));
      }
      for (Index v = 0; v < soup.n_vertices(); ++v) {
        soup.vertex_ids.named.push_back(static_cast<std::int32_t>(3 * v + 1));
      }
      break;
    case 1:
      soup.format = Format::Obj;
      for (Index f = below(random, 9); f < soup.n_faces(); f += 1 + below(random, 60)) {
        soup.groups.push_back({"group " + std::to_string(f), f});
      }
      break;
    case 2:
      soup.format = Format::Ply;
      for (const Vec3& p : soup.positions) {
        soup.normals.push_back((below(random, 20) == 0 ? -1.0 : 1.0) * p.normalized());
      }
      soup.corner_normals = soup.triangles;
      break;
    default:
      break;
  }
}

}  // namespace

const std::vector<NamedSoup>& good_meshes() {
  static const std::vector<NamedSoup> all{
      {"torus", shapes::torus(3, 1, 9, 7)},
      {"icosphere", shapes::icosphere(1)},
      {"genus block", shapes::genus_block(2)},
      {"cavity", shapes::nested_cubes(shapes::InnerShell::Cavity)},
      {"octahedron", shapes::uv_sphere(2, 4)},
      {"sphere", shapes::uv_sphere(7, 9)},
      {"two solids",
       shapes::merged(shapes::cube(), shapes::translated(shapes::icosphere(0), Vec3(3, 2, 1)))}};
  return all;
}

NamedSoup damaged_mesh(std::uint32_t seed) {
  std::mt19937 random(seed);
  NamedSoup result = good_meshes()[below(random, static_cast<Index>(good_meshes().size()))];
  for (Index n = 1 + below(random, 5); n > 0; --n) {
    const Damage& damage = kDamages[below(random, kDamages.size())];
    damage.make(result.soup, random);
    result.name.append(", ").append(damage.name);
  }
  dress_up(result.soup, random);
  result.name.append(", seed ").append(std::to_string(seed));
  return result;
}

}  // namespace meshalyzer
