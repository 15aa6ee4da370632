#include "meshalyzer/repair/edits/internal/edited_normals.h"

#include "meshalyzer/io/references.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the mean of the normals of the old vertices that share a face with each new one; zero if
/// there is none.
std::vector<Vec3> neighbour_means(const Soup& before, const EditedFaces& faces,
                                  std::size_t n_added) {
  const std::size_t n_old = before.n_vertices();
  std::vector<Vec3> means(n_added, Vec3::Zero());
  for (std::size_t f = 0; f < faces.triangles.size(); ++f) {
    for (const Index v : faces.triangles[f]) {
      if (v == kNoIndex || v < n_old) continue;
      for (const Index other : faces.triangles[f]) {
        if (other < n_old) means[v - n_old] += before.normals[other];
      }
    }
  }
  for (Vec3& mean : means) {
    const double length = mean.norm();
    if (length > 0.0) mean /= length;
  }
  return means;
}

/// Sets the normals of formats with one normal for each vertex.
void set_vertex_normals(const Soup& before, const Edits& edits, const EditedFaces& faces,
                        std::span<const Index> vertices, Soup& result) {
  const std::size_t n_old = before.n_vertices();
  std::vector<Vec3> added = neighbour_means(before, faces, edits.added_vertices.size());
  for (std::size_t i = 0; i < added.size(); ++i) {
    const Index copied = edits.added_vertices[i].copy_of;
    if (copied != kNoIndex) added[i] = before.normals[copied];
  }
  result.normals.clear();
  for (const Index v : vertices) {
    result.normals.push_back(v < n_old ? before.normals[v] : added[v - n_old]);
  }
  result.corner_normals = result.triangles;
}

/// Returns the normals of an old face for its new corners: a vertex that stays keeps its normal,
/// any other gets that of the corner that it replaces.
Triangle carried_over(const Triangle& corners, const Triangle& normals, const Triangle& now) {
  Triangle result = normals;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (corners[j] == now[k]) result[k] = normals[j];
    }
  }
  return result;
}

/// Returns, by old vertex, the normal of the first corner there that has one.
std::vector<Index> first_normals(const Soup& soup) {
  std::vector<Index> first(soup.n_vertices(), kNoIndex);
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = soup.triangles[f][k];
      if (v != kNoIndex && first[v] == kNoIndex) first[v] = soup.corner_normals[f][k];
    }
  }
  return first;
}

/// Returns the normals of an added face: those of its model at common corners, else any of the
/// vertex; none if a corner has none, since a face has all or none.
Triangle normals_of_added(const Soup& before, const Edits& edits, const Edits::AddedFace& face,
                          std::span<const Index> first) {
  Triangle normals = kNoTriangle;
  for (std::size_t k = 0; k < 3; ++k) {
    Index v = face.corners[k];
    if (v >= before.n_vertices()) v = edits.added_vertices[v - before.n_vertices()].copy_of;
    if (v == kNoIndex) return kNoTriangle;
    normals[k] = first[v];
    const Triangle& corners = before.triangles[face.prototype];
    for (std::size_t j = 0; j < 3; ++j) {
      if (corners[j] == v) normals[k] = before.corner_normals[face.prototype][j];
    }
    if (normals[k] == kNoIndex) return kNoTriangle;
  }
  return normals;
}

/// A list of normals that corners refer to.
void set_corner_normals(const Soup& before, const Edits& edits, const EditedFaces& faces,
                        Soup& result) {
  const std::size_t n_old = before.n_faces();
  const std::vector<Index> first =
      edits.added_faces.empty() ? std::vector<Index>{} : first_normals(before);
  result.normals = before.normals;
  result.corner_normals.clear();
  result.corner_normals.reserve(faces.sources.size());
  for (std::size_t f = 0; f < faces.sources.size(); ++f) {
    const Index source = faces.sources[f];
    result.corner_normals.push_back(
        source < n_old ? carried_over(before.triangles[source], before.corner_normals[source],
                                      faces.triangles[f])
                       : normals_of_added(before, edits, edits.added_faces[source - n_old], first));
  }
}

/// Replaces all normals of the corners at a vertex by one new normal.
void change_normals(const Edits& edits, const SkippedOperations& skipped,
                    std::span<const Index> vertices, Soup& result) {
  const bool one_a_vertex = has_vertex_normals(result);
  std::vector<Index> new_normal;
  for (const Edits::ChangedNormal& change : edits.changed_normals) {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), change.vertex);
    if (skipped(change.op) || found == vertices.end() || *found != change.vertex) continue;
    const auto v = static_cast<std::size_t>(found - vertices.begin());
    if (one_a_vertex) {
      result.normals[v] = change.normal;
      continue;
    }
    new_normal.resize(result.n_vertices(), kNoIndex);
    new_normal[v] = static_cast<Index>(result.normals.size());
    result.normals.push_back(change.normal);
  }
  if (new_normal.empty()) return;
  for (std::size_t f = 0; f < result.n_faces(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = result.triangles[f][k];
      Index& normal = result.corner_normals[f][k];
      if (v != kNoIndex && normal != kNoIndex && new_normal[v] != kNoIndex) normal = new_normal[v];
    }
  }
}

}  // namespace

void set_edited_normals(const Soup& before, const Edits& edits, const SkippedOperations& skipped,
                        const EditedFaces& faces, std::span<const Index> vertices, Soup& result) {
  if (before.corner_normals.empty()) {
    result.normals = before.normals;
    return;
  }
  if (has_vertex_normals(before)) {
    set_vertex_normals(before, edits, faces, vertices, result);
  } else {
    set_corner_normals(before, edits, faces, result);
  }
  change_normals(edits, skipped, vertices, result);
}

}  // namespace meshalyzer
