#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/facets/internal/facet_shape.h"

#include <algorithm>

namespace meshalyzer {

WorkingMesh::WorkingMesh(const Soup& soup, std::span<const Index> thin_faces, double tolerance)
    : triangles_(soup.triangles),
      positions_(soup.positions),
      is_thin_(soup.n_faces(), 0),
      n_original_faces_(soup.n_faces()),
      tolerance_(tolerance) {
  for (const Index f : thin_faces) is_thin_[f] = 1;
  for (Triangle& t : triangles_) {
    if (!is_in_complex(t)) t = kNoTriangle;
  }
  faces_ = ItemsByGroup(positions_.size(), [&](const auto& use) {
    for (Index f = 0; f < triangles_.size(); ++f) {
      if (!has(f)) continue;
      for (const Index v : triangles_[f]) use(v, f);
    }
  });
}

Corners WorkingMesh::corners_after(const MendStep& step, const Triangle& t) const {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k] == positions_.size()) {
      corners[k] = step.added_vertex->position;
    } else {
      corners[k] = step.moved && t[k] == step.moved->vertex ? step.moved->to : positions_[t[k]];
    }
  }
  return corners;
}

std::span<const Index> WorkingMesh::faces_at(Index vertex) const {
  const auto changed = changed_.find(vertex);
  if (changed != changed_.end()) return changed->second;
  if (is_added(vertex)) return {};
  return faces_[vertex];
}

std::vector<Index> WorkingMesh::faces_at(Index a, Index b) const {
  const bool a_has_fewer = faces_at(a).size() <= faces_at(b).size();
  const Index other = a_has_fewer ? b : a;
  std::vector<Index> faces;
  for (const Index f : faces_at(a_has_fewer ? a : b)) {
    if (has_corner(triangles_[f], other)) faces.push_back(f);
  }
  return faces;
}

bool WorkingMesh::are_joined(Index a, Index b) const {
  const bool a_has_fewer = faces_at(a).size() <= faces_at(b).size();
  const Index other = a_has_fewer ? b : a;
  const auto faces = faces_at(a_has_fewer ? a : b);
  return std::any_of(faces.begin(), faces.end(),
                     [&](Index f) { return has_corner(triangles_[f], other); });
}

std::vector<Index> WorkingMesh::neighbours(Index vertex) const {
  std::vector<Index> result;
  for (const Index f : faces_at(vertex)) {
    for (const Index v : triangles_[f]) {
      if (v != vertex) result.push_back(v);
    }
  }
  sort_unique(result);
  return result;
}

void WorkingMesh::make(const MendStep& step) {
  if (step.moved) positions_[step.moved->vertex] = step.moved->to;
  if (step.added_vertex) {
    const Index copied = step.added_vertex->copy_of;
    copied_from_.push_back(is_added(copied) ? copied_from(copied) : copied);
    positions_.push_back(step.added_vertex->position);
  }
  for (const MendStep::NewCorners& change : step.changed) {
    detach(change.face);
    if (change.corners != kNoTriangle) attach(change.face, change.corners);
  }
  for (const MendStep::NewFace& face : step.added) {
    prototypes_.push_back(original(face.prototype));
    triangles_.push_back(kNoTriangle);
    is_thin_.push_back(0);
    attach(static_cast<Index>(triangles_.size() - 1), face.corners);
  }
  if (!step.moved) return;
  for (const Index f : faces_at(step.moved->vertex)) check(f);
}

std::vector<Index>& WorkingMesh::own_faces(Index vertex) {
  const auto found = changed_.find(vertex);
  if (found != changed_.end()) return found->second;
  const auto faces = faces_at(vertex);
  return changed_.emplace(vertex, std::vector<Index>(faces.begin(), faces.end())).first->second;
}

void WorkingMesh::detach(Index face) {
  for (const Index v : triangles_[face]) {
    std::vector<Index>& faces = own_faces(v);
    faces.erase(std::find(faces.begin(), faces.end(), face));
  }
  triangles_[face] = kNoTriangle;
  is_thin_[face] = 0;
}

void WorkingMesh::attach(Index face, const Triangle& corners) {
  for (const Index v : corners) own_faces(v).push_back(face);
  triangles_[face] = corners;
  check(face);
}

void WorkingMesh::check(Index face) {
  is_thin_[face] = measure_facet(corners(triangles_[face])).is_sound(tolerance_) ? 0 : 1;
}

}  // namespace meshalyzer
