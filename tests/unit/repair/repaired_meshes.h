#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/fix_defects.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {

inline const Soup& only_mesh(const RepairResult& result) {
  EXPECT_EQ(result.meshes.size(), 1U);
  return result.meshes.front().tracked.soup;
}

[[nodiscard]] inline std::size_t count_after(const RepairResult& result, DefectCode code) {
  std::size_t n = 0;
  for (const RepairedMesh& mesh : result.meshes) n += mesh.remaining.count(code);
  return n;
}

/// Tells whether a mesh is closed, manifold, oriented outwards and embedded.
[[nodiscard]] inline bool is_good(const Soup& soup) {
  const PreparedMesh mesh(soup);
  const CutMesh& cut = mesh.cut();
  if (soup.triangles.empty() || !cut.side.non_manifold_vertices.empty()) return false;
  for (const auto h : cut.mesh.halfedges()) {
    if (cut.mesh.is_boundary(h)) return false;
  }
  for (const Shell& shell : mesh.shells()) {
    if (shell.outward != true) return false;
  }
  return mesh.intersecting_pairs().empty();
}

/// Tells whether a note has this in it.
[[nodiscard]] inline bool is_noted(const RepairResult& result, std::string_view what) {
  return std::any_of(result.notes.begin(), result.notes.end(),
                     [&](const std::string& note) { return note.find(what) != std::string::npos; });
}

/// Tells whether a refusal of this code has this in its reason.
[[nodiscard]] inline bool is_refused(const RepairResult& result, DefectCode code,
                                     std::string_view why) {
  return std::any_of(result.log.refusals.begin(), result.log.refusals.end(),
                     [&](const LoggedRefusal& refusal) {
                       return refusal.code == code && refusal.reason.find(why) != std::string::npos;
                     });
}

/// Expects that a mesh has a defect, and nothing at all after the repair.
inline RepairResult expect_mended(const Soup& soup, DefectCode code,
                                  const RepairOptions& options = {}) {
  RepairResult result = fix_defects(soup, options);
  EXPECT_GT(result.before.count(code), 0U) << defect_name(code);
  for (const RepairedMesh& mesh : result.meshes) {
    EXPECT_EQ(mesh.remaining.total(), mesh.remaining.count(DefectCode::Numbering))
        << defect_name(code);
  }
  EXPECT_FALSE(result.log.operations.empty());
  return result;
}

/// Gauss: a sixth of the sum of the corners' triple products.
[[nodiscard]] inline double volume_of(const Soup& soup) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles) {
    sum += soup.positions[t[0]].dot(soup.positions[t[1]].cross(soup.positions[t[2]]));
  }
  return sum / 6;
}

/// The cube with an id for every record, face ids from 11 on and vertex ids from 101 on.
[[nodiscard]] inline Soup cube_with_ids() {
  Soup soup = shapes::cube();
  for (int f = 0; f < 12; ++f) soup.face_ids.named.push_back(11 + f);
  for (int v = 0; v < 8; ++v) soup.vertex_ids.named.push_back(101 + v);
  return soup;
}

/// A cube in a PLY file, a normal at each vertex, away from the middle.
[[nodiscard]] inline Soup cube_with_normals() {
  Soup soup = shapes::cube();
  soup.format = Format::Ply;
  for (const Vec3& p : soup.positions) soup.normals.push_back(p - Vec3(0.5, 0.5, 0.5));
  soup.corner_normals = soup.triangles;
  return soup;
}

[[nodiscard]] inline Soup cube_with_groups() {
  Soup soup = shapes::cube();
  soup.format = Format::Obj;
  soup.groups = {{"low", 2}, {"empty", 5}, {"high", 5}};
  return soup;
}

/// An icosahedron, an edge of it split in both its faces right beside its end: two needles.
[[nodiscard]] inline Soup with_needles() {
  Soup soup = shapes::icosphere(0);
  const Triangle first = soup.triangles.front();
  const Index a = first[0];
  const Index b = first[1];
  const auto m = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(soup.positions[a] + 1e-12 * (soup.positions[b] - soup.positions[a]));
  const std::size_t n = soup.n_faces();
  for (std::size_t f = 0; f < n; ++f) {
    Triangle t = soup.triangles[f];
    const bool has_a = std::find(t.begin(), t.end(), a) != t.end();
    const bool has_b = std::find(t.begin(), t.end(), b) != t.end();
    if (!has_a || !has_b) continue;
    std::replace(soup.triangles[f].begin(), soup.triangles[f].end(), a, m);
    std::replace(t.begin(), t.end(), b, m);
    soup.triangles.push_back(t);
  }
  return soup;
}

/// The first face of an icosahedron split at a point that is on, or almost on, its first edge.
[[nodiscard]] inline Soup with_cap(double height) {
  Soup soup = shapes::icosphere(0);
  const auto [a, b, c] = soup.triangles.front();
  const Vec3 middle = 0.5 * (soup.positions[a] + soup.positions[b]);
  const auto m = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(middle + height * (soup.positions[c] - middle));
  soup.triangles.front() = {a, b, m};
  soup.triangles.push_back({b, c, m});
  soup.triangles.push_back({c, a, m});
  return soup;
}

}  // namespace meshalyzer
