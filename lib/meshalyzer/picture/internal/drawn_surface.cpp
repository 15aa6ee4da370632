#include "meshalyzer/picture/internal/drawn_surface.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

Box3 box_of_vertices(const Soup& soup) {
  Box3 box;
  for (const Vec3& p : soup.positions) {
    if (p.allFinite()) box.extend(p);
  }
  return box;
}

/// Numbers the vertices that are used in the order of their records.
std::vector<Index> number_vertices(const std::vector<std::uint8_t>& is_used,
                                   std::vector<Index>& numbered) {
  std::vector<Index> number(is_used.size(), kNoIndex);
  for (Index v = 0; v < is_used.size(); ++v) {
    if (is_used[v] == 0) continue;
    number[v] = static_cast<Index>(numbered.size());
    numbered.push_back(v);
  }
  return number;
}

}  // namespace

bool is_drawable(const Soup& soup, Index face) {
  const Triangle& t = soup.triangles[face];
  return std::all_of(t.begin(), t.end(),
                     [&](Index v) { return v != kNoIndex && soup.positions[v].allFinite(); });
}

std::vector<Index> drawable_faces(const Soup& soup) {
  std::vector<Index> faces;
  faces.reserve(soup.n_faces());
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (is_drawable(soup, f)) faces.push_back(f);
  }
  return faces;
}

Box3 box_of(const Soup& soup, std::span<const Index> faces) {
  if (faces.empty()) return box_of_vertices(soup);
  Box3 box;
  for (const Index f : faces) {
    for (const Index v : soup.triangles[f]) box.extend(soup.positions[v]);
  }
  return box;
}

TriangleList triangles_of(const Soup& soup, std::vector<Index> faces) {
  TriangleList list;
  list.triangles.reserve(faces.size());
  for (const Index f : faces) list.triangles.push_back(soup.triangles[f]);
  list.faces = std::move(faces);
  return list;
}

std::vector<std::uint8_t> used_vertices(const Soup& soup, const TriangleList& list) {
  std::vector<std::uint8_t> is_used(soup.n_vertices(), 0);
  for (const Triangle& t : list.triangles) {
    for (const Index v : t) is_used[v] = 1;
  }
  return is_used;
}

DrawnSurface draw_surface(const Soup& soup, const DrawingFrame& frame, TriangleList list,
                          std::span<const Vec3> normals) {
  DrawnSurface surface;
  const std::vector<Index> number = number_vertices(used_vertices(soup, list), surface.vertices);
  surface.positions.reserve(3 * surface.n_vertices());
  surface.normals.reserve(3 * surface.n_vertices());
  for (const Index v : surface.vertices) {
    append_point(surface.positions, frame(soup.positions[v]));
    append_point(surface.normals, normals[v]);
  }
  surface.triangles.reserve(3 * list.triangles.size());
  for (const Triangle& t : list.triangles) {
    for (const Index v : t) surface.triangles.push_back(number[v]);
  }
  surface.faces = std::move(list.faces);
  return surface;
}

}  // namespace meshalyzer
