#include "meshalyzer/repair/holes/smooth_patch.h"

#include "meshalyzer/repair/holes/fair_patch.h"
#include "meshalyzer/repair/holes/refine_patch.h"

#include <utility>

namespace meshalyzer {

std::optional<Patch> smooth_patch(const PreparedMesh& mesh, const HoleLoop& loop,
                                  const TakenEdges& taken, const Patch& patch) {
  PatchSoup own = make_soup(mesh.soup(), patch);
  WorkingPatch working{.mesh = build(own.soup).mesh, .names = std::move(own.vertices)};
  if (working.mesh.n_vertices() != working.names.size()) return std::nullopt;
  refine_patch(mesh, loop, taken, working);
  if (!fair_patch(mesh, loop, working)) return std::nullopt;

  Patch result;
  const std::size_t n_loop = working.names.size();
  for (std::size_t i = n_loop; i < working.mesh.n_vertices(); ++i) {
    const Vec3& place = working.mesh.point(VertexHandle(static_cast<int>(i)));
    if (!place.allFinite()) return std::nullopt;
    result.added.push_back(place);
  }
  const auto first_added = static_cast<Index>(mesh.soup().n_vertices());
  for (const FaceHandle f : working.mesh.faces()) {
    Triangle t{};
    std::size_t k = 0;
    for (const VertexHandle v : working.mesh.fv_range(f)) {
      const auto i = static_cast<std::size_t>(v.idx());
      t[k++] = i < n_loop ? working.names[i] : static_cast<Index>(first_added + i - n_loop);
    }
    result.triangles.push_back(t);
  }
  return result;
}

}  // namespace meshalyzer
