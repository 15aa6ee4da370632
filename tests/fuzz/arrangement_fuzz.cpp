#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/exact/exact_point.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// On so few points nearly all faces meet each other: more of them only take longer.
constexpr std::size_t kMaxFaces = 16;
constexpr std::size_t kVertices = 10;

/// On a lattice of 4 x 4 x 4 points, some of them a little off it: a byte a vertex.
Vec3 position(std::uint8_t code) {
  constexpr std::array<double, 4> kOffsets{0.0, 0.0, 0x1p-50, 0.3};
  Vec3 place(code % 4U, code / 4U % 4U, code / 16U % 4U);
  place.x() += kOffsets[code / 64U];
  return place;
}

void require(bool holds) {
  if (!holds) __builtin_trap();
}

bool has_no_area(const Soup& soup, const Triangle& face) {
  const auto& at = soup.positions;
  return is_in_complex(face) && are_collinear(at[face[0]], at[face[1]], at[face[2]]);
}

/// Where all points made are doubles, the exact search must find nothing left to cut.
void check_contacts(const Arrangement& a) {
  for (std::size_t v = a.n_input_vertices; v < a.positions.size(); ++v) {
    if (!a.exact.made(v - a.n_input_vertices).is_rounded()) return;
  }
  Soup soup;
  soup.positions = a.positions;
  soup.triangles = a.pieces;
  const CutMesh cut = build(soup);
  require(find_self_intersections(cut, FaceTree(cut)).empty());
}

/// The areas of a face's pieces must add up to its own, as far as doubles tell.
void check_areas(const Soup& soup, const Arrangement& a) {
  const auto area = [&](const Triangle& t) -> Vec3 {
    const Vec3 u = a.positions[t[1]] - a.positions[t[0]];
    return u.cross(a.positions[t[2]] - a.positions[t[0]]);
  };
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (!is_in_complex(soup.triangles[f])) continue;
    Vec3 sum = -area(soup.triangles[f]);
    for (const Index piece : a.pieces_of(f)) {
      for (const PieceSource& source : a.sources_of(piece)) {
        if (source.face == f) sum += source.sign * area(a.pieces[piece]);
      }
    }
    require(sum.cwiseAbs().maxCoeff() < 1e-9);
  }
}

}  // namespace
}  // namespace meshalyzer

/// A byte a vertex, then three bytes a face. However the faces meet, each must be the sum of its
/// pieces, and pieces must not meet but in what they have in common.
///
/// Faces of no area are left out: pieces beside one may touch the edges of others, a limitation
/// that doc/architecture.md describes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meshalyzer;
  if (size < kVertices) return 0;
  Soup soup;
  for (std::size_t i = 0; i < kVertices; ++i) soup.positions.push_back(position(data[i]));
  const std::size_t end = std::min(size, kVertices + 3 * kMaxFaces);
  for (std::size_t i = kVertices; i + 3 <= end; i += 3) {
    const Triangle face{static_cast<Index>(data[i] % kVertices),
                        static_cast<Index>(data[i + 1] % kVertices),
                        static_cast<Index>(data[i + 2] % kVertices)};
    if (!has_no_area(soup, face)) soup.triangles.push_back(face);
  }
  const Arrangement arrangement = arrange(soup);
  check_areas(soup, arrangement);
  check_contacts(arrangement);
  return 0;
}
