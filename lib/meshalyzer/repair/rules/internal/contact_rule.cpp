#include "meshalyzer/repair/rules/internal/contact_rule.h"

namespace meshalyzer {
namespace {

bool is_same_vertex(Index a, Index b) {
  return a == b;
}

}  // namespace

bool are_in_contact(const PlacedFace& a, const PlacedFace& b) {
  return are_in_contact(a, b, is_same_vertex);
}

bool are_in_contact_beyond_copies(const PlacedFace& a, const PlacedFace& b) {
  if (!are_in_contact(a, b)) return false;
  if (count_common_vertices(a, b) != 0) return true;
  const auto [p, q, n_common] = align_faces(
      a.corners, b.corners, [](const Vec3& one, const Vec3& other) { return one == other; });
  return n_common != 1 || find_contact(p, q, Common::Vertex).has_value();
}

std::size_t count_common_vertices(const PlacedFace& a, const PlacedFace& b) {
  return align_faces(a.vertices, b.vertices, is_same_vertex).n_common;
}

}  // namespace meshalyzer
