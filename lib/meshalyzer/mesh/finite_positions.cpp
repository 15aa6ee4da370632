#include "meshalyzer/mesh/finite_positions.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <span>

namespace meshalyzer {

namespace {

bool are_finite(std::span<const Vec3> positions) {
  const auto parts = map_chunks<char>(positions.size(), [&](Chunk chunk) {
    const auto some = positions.subspan(chunk.begin, chunk.end - chunk.begin);
    return static_cast<char>(
        std::all_of(some.begin(), some.end(), [](const Vec3& p) { return p.allFinite(); }));
  });
  return std::all_of(parts.begin(), parts.end(), [](char finite) { return finite != 0; });
}

void require_finite(std::span<const Vec3> positions) {
  if (!are_finite(positions)) throw InvalidArgument("a position of the mesh is not finite");
}

}  // namespace

bool has_finite_positions(const Soup& soup) {
  return are_finite(soup.positions);
}

void require_finite_positions(const Soup& soup) {
  require_finite(soup.positions);
}

void require_finite_positions(const TriMesh& mesh) {
  require_finite({mesh.points(), mesh.n_vertices()});
}

}  // namespace meshalyzer
