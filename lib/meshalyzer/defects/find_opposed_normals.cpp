#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/faces_at.h"
#include "meshalyzer/defects/opposed_normals.h"
#include "meshalyzer/exact/facing.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The relation of a face to a normal at one of its vertices.
enum class Say : std::uint8_t {
  /// The face has no area, or is not in the complex.
  None,
  Opposed,
  /// The face does not face away from the normal.
  NotOpposed,
};

Say say_of(const Soup& soup, Index face, const Vec3& normal) {
  const Triangle& t = soup.triangles[face];
  if (!is_in_complex(t)) return Say::None;
  const Vec3& a = soup.positions[t[0]];
  const Vec3& b = soup.positions[t[1]];
  const Vec3& c = soup.positions[t[2]];
  const Sign sign = facing(normal, a, b, c);
  if (sign < 0) return Say::Opposed;
  return sign == 0 && are_collinear(a, b, c) ? Say::None : Say::NotOpposed;
}

/// Returns the normals that may be opposed, because their own face does not agree with them. In a
/// sound mesh only faces of zero area have such normals.
std::vector<GivenNormal> find_suspects(const Soup& soup) {
  auto suspects = collect_chunks<GivenNormal>(
      soup.n_faces(), [&](Chunk chunk, std::vector<GivenNormal>& found) {
        for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
          const auto face = static_cast<Index>(f);
          for (std::size_t k = 0; k < 3; ++k) {
            const Index vertex = soup.triangles[f][k];
            const Index normal = soup.corner_normals[f][k];
            if (vertex == kNoIndex || normal == kNoIndex) continue;
            const Vec3& direction = soup.normals[normal];
            if (direction.allFinite() && say_of(soup, face, direction) != Say::NotOpposed) {
              found.push_back({vertex, normal});
            }
          }
        }
      });
  sort_unique(suspects);
  return suspects;
}

/// Tells whether a normal is opposed to all faces of non-zero area, of which there must be one. A
/// face that agrees with the normal is moved to the front: it is likely to agree with the next
/// normal at the vertex too.
bool is_opposed(const Soup& soup, std::vector<Index>& faces, const Vec3& normal) {
  bool any = false;
  for (Index& face : faces) {
    const Say say = say_of(soup, face, normal);
    if (say == Say::NotOpposed) {
      std::swap(face, faces.front());
      return false;
    }
    any = any || say == Say::Opposed;
  }
  return any;
}

}  // namespace

std::vector<GivenNormal> opposed_normals(const PreparedMesh& mesh) {
  const Soup& soup = mesh.soup();
  std::vector<GivenNormal> opposed;
  if (soup.corner_normals.empty()) return opposed;
  std::vector<Index> faces;
  Index vertex = kNoIndex;
  for (const GivenNormal& given : find_suspects(soup)) {
    if (given.vertex != vertex) faces = faces_at(mesh.cut(), given.vertex);
    vertex = given.vertex;
    if (is_opposed(soup, faces, soup.normals[given.normal])) opposed.push_back(given);
  }
  return opposed;
}

DefectList find_opposed_normals(const PreparedMesh& mesh) {
  DefectList defects;
  Index vertex = kNoIndex;
  for (const GivenNormal& given : opposed_normals(mesh)) {
    if (given.vertex == vertex) continue;
    vertex = given.vertex;
    Defect defect = make_defect(DefectCode::VertexNormal);
    defect.vertices = {vertex};
    defect.positions = {mesh.soup().positions[vertex]};
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
