#include "meshalyzer/arrangement/rounded_faces.h"

#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {

RoundedFaceEdits::RoundedFaceEdits(RoundedFaces& faces)
    : faces_(faces), faces_of_(faces.positions.size()) {
  for (Index face = 0; face < faces.triangles.size(); ++face) {
    for (const Index v : faces.triangles[face]) faces_of_[v].push_back(face);
  }
}

void RoundedFaceEdits::collapse(Index vertex, Index into) {
  for (const Index face : std::exchange(faces_of_[vertex], {})) {
    Triangle& t = faces_.triangles[face];
    if (!has_corner(t, vertex)) continue;
    if (has_corner(t, into)) {
      t = kNoTriangle;
      continue;
    }
    t = with_corner(t, vertex, into);
    faces_of_[into].push_back(face);
    change(face);
  }
}

void RoundedFaceEdits::split_edge(Index a, Index b, Index through) {
  const std::vector<Index> round_a = faces_of_[a];
  for (const Index face : round_a) {
    const Triangle t = faces_.triangles[face];
    if (!has_corner(t, a) || !has_corner(t, b)) continue;
    if (has_corner(t, through)) {
      faces_.triangles[face] = kNoTriangle;
      continue;
    }
    faces_.triangles[face] = with_corner(t, b, through);
    faces_of_[through].push_back(face);
    change(face);
    add(with_corner(t, a, through), face);
  }
}

std::vector<Index> RoundedFaceEdits::take_changed() {
  return std::exchange(changed_, {});
}

void RoundedFaceEdits::finish() {
  std::size_t n = 0;
  for (Index face = 0; face < faces_.triangles.size(); ++face) {
    if (!stays(face)) continue;
    faces_.triangles[n] = faces_.triangles[face];
    faces_.ages[n] = faces_.ages[face];
    faces_.origins[n] = faces_.origins[face];
    ++n;
  }
  faces_.triangles.resize(n);
  faces_.ages.resize(n);
  faces_.origins.resize(n);
}

void RoundedFaceEdits::change(Index face) {
  faces_.ages[face] = FaceAge::New;
  changed_.push_back(face);
}

void RoundedFaceEdits::add(const Triangle& t, Index like) {
  const auto face = static_cast<Index>(faces_.triangles.size());
  faces_.triangles.push_back(t);
  faces_.ages.push_back(FaceAge::New);
  faces_.origins.push_back(faces_.origins[like]);
  for (const Index v : t) faces_of_[v].push_back(face);
  changed_.push_back(face);
}

bool RoundedFaceEdits::stays(Index face) const {
  if (is_removed(face)) return false;
  return faces_.ages[face] == FaceAge::Old ||
         !are_collinear(corners_of(faces_.positions, faces_.triangles[face]));
}

}  // namespace meshalyzer
