#include "meshalyzer/repair/orient/bounds_solid.h"

#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/orient/internal/side_votes.h"
#include "meshalyzer/topology/border.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

/// #file faces: 1 for those that must be turned to make the mesh consistent. Parts that no turning
/// makes consistent stay as they are.
std::vector<std::uint8_t> which_are_flipped(const PreparedMesh& mesh) {
  std::vector<std::uint8_t> is_flipped(mesh.soup().n_faces(), 0);
  for (const Defect& region : find_flipped(mesh)) {
    for (const Index face : region.faces) is_flipped[face] = region.fixable ? 1 : 0;
  }
  return is_flipped;
}

bool separates(std::vector<Corners> triangles) {
  const std::vector<SurfaceSample> samples = sample_surface(triangles);
  return count_votes(WindingNumbers(std::move(triangles)), samples).bounds_solid();
}

}  // namespace

std::vector<std::uint8_t> which_are_closed(const CutMesh& cut, const Components& components) {
  std::vector<std::uint8_t> is_closed(components.count, 1);
  for (const HalfedgeHandle h : find_border_edges(cut)) {
    is_closed[components.of(cut.mesh, h)] = 0;
  }
  return is_closed;
}

std::vector<std::uint8_t> bounds_solid(const PreparedMesh& mesh, const Components& components,
                                       const StopQuery& wants_to_stop) {
  std::vector<std::uint8_t> is_solid = which_are_closed(mesh.cut(), components);
  if (std::find(is_solid.begin(), is_solid.end(), 0) == is_solid.end()) return is_solid;
  const std::vector<std::uint8_t> is_flipped = which_are_flipped(mesh);
  const ItemsByGroup faces(components.of_face, components.count);
  parallel_chunks(components.count, 1, [&](Chunk chunk) {
    if (is_solid[chunk.begin] != 0 || wants_to_stop()) return;
    std::vector<Corners> triangles;
    triangles.reserve(faces[chunk.begin].size());
    for (const Index f : faces[chunk.begin]) {
      const Index face = mesh.cut().side.faces[f];
      triangles.push_back(corners_of(mesh.soup(), face));
      if (is_flipped[face] != 0) std::swap(triangles.back()[1], triangles.back()[2]);
    }
    is_solid[chunk.begin] = separates(std::move(triangles)) ? 1 : 0;
  });
  return is_solid;
}

}  // namespace meshalyzer
