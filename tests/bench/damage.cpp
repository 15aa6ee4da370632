#include "damage.h"

#include "meshalyzer/mesh/build.h"

#include <algorithm>
#include <vector>

namespace meshalyzer::bench {
namespace {

/// A share of the length of an edge, far below the default tolerance.
constexpr double kTiny = 1e-9;

/// One place to be damaged: a face, and the mesh before any damage.
struct Place {
  const CutMesh& intact;
  Index face;
};

void split_edge_near_its_end(Soup& soup, const Place& place) {
  const FaceHandle face(static_cast<int>(place.face));
  const HalfedgeHandle h = place.intact.mesh.halfedge_handle(face);
  const HalfedgeHandle opposite = place.intact.mesh.opposite_halfedge_handle(h);
  const auto a = static_cast<Index>(place.intact.mesh.from_vertex_handle(h).idx());
  const auto b = static_cast<Index>(place.intact.mesh.to_vertex_handle(h).idx());
  const auto m = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(soup.positions[a] + kTiny * (soup.positions[b] - soup.positions[a]));
  for (const HalfedgeHandle side : {h, opposite}) {
    Triangle& old = soup.triangles[place.intact.side.face(place.intact.mesh.face_handle(side))];
    Triangle half = old;
    std::replace(old.begin(), old.end(), a, m);
    std::replace(half.begin(), half.end(), b, m);
    soup.triangles.push_back(half);
  }
}

void split_face_near_an_edge(Soup& soup, Index face) {
  const Triangle t = soup.triangles[face];
  const Vec3 middle = 0.5 * (soup.positions[t[0]] + soup.positions[t[1]]);
  const auto m = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(middle + kTiny * (soup.positions[t[2]] - middle));
  soup.triangles[face] = {t[0], t[1], m};
  soup.triangles.push_back({t[1], t[2], m});
  soup.triangles.push_back({t[2], t[0], m});
}

void give_own_vertices(Soup& soup, Index face) {
  for (Index& v : soup.triangles[face]) {
    soup.positions.push_back(soup.positions[v]);
    v = static_cast<Index>(soup.n_vertices() - 1);
  }
}

void damage(Soup& soup, const Place& place, std::size_t kind, std::vector<Index>& taken_out) {
  Triangle& triangle = soup.triangles[place.face];
  switch (kind % 8) {
    case 0:
      taken_out.push_back(place.face);
      break;
    case 1:
      std::swap(triangle[0], triangle[1]);
      break;
    case 2:
      soup.triangles.push_back(Triangle(triangle));
      break;
    case 3:
      split_edge_near_its_end(soup, place);
      break;
    case 4:
      split_face_near_an_edge(soup, place.face);
      break;
    case 5:
      give_own_vertices(soup, place.face);
      break;
    case 6:
      soup.positions.push_back(soup.positions[triangle[0]]);
      break;
    default:
      soup.triangles.push_back({triangle[0], triangle[0], triangle[1]});
  }
}

}  // namespace

Soup damaged(Soup soup, std::size_t n) {
  const CutMesh intact = build(soup);
  const std::size_t step = soup.n_faces() / n;
  std::vector<Index> taken_out;
  for (std::size_t i = 0; i < n; ++i) {
    damage(soup, {intact, static_cast<Index>(i * step)}, i, taken_out);
  }
  for (auto face = taken_out.rbegin(); face != taken_out.rend(); ++face) {
    soup.triangles.erase(soup.triangles.begin() + *face);
  }
  return soup;
}

}  // namespace meshalyzer::bench
