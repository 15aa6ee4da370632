#include "meshalyzer/prepared/shells.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/geometry/volume.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/nesting.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

namespace meshalyzer {
namespace {

/// Returns the component of each mesh face, or kNoIndex if that is no shell.
std::vector<Index> shell_of_face(const Components& components,
                                 std::span<const std::uint8_t> is_shell) {
  std::vector<Index> of_face(components.of_face);
  for (Index& c : of_face) {
    c = is_shell[c] != 0 ? c : kNoIndex;
  }
  return of_face;
}

/// Returns the nesting of the components, or nothing if the intersecting pairs are not fully known.
std::optional<Nesting> nesting_of_components(const PreparedMesh& mesh,
                                             std::span<const std::uint8_t> is_shell) {
  const Components& components = mesh.components();
  if (components.count == 1) {
    return Nesting{.depth = {0}, .inside = {kNoIndex}};  // no tree is needed
  }
  if (!mesh.intersection_counts().is_complete) return std::nullopt;
  return find_nesting(mesh.tree(),
                      {.parts = {.of_face = components.of_face, .count = components.count},
                       .boxes = mesh.component_boxes(),
                       .is_closed = is_shell,
                       .contacts = mesh.intersection_counts().contacts});
}

}  // namespace

std::vector<Shell> find_shells(const PreparedMesh& mesh) {
  const Components& components = mesh.components();
  const std::vector<std::uint8_t> is_shell = which_are_shells(mesh.cut(), components);
  std::vector<Shell> shells(components.count);
  if (std::find(is_shell.begin(), is_shell.end(), 1) == is_shell.end()) {
    return shells;  // no need to search for intersections
  }
  const std::vector<Index> of_face = shell_of_face(components, is_shell);
  const std::vector<SignedVolume> volumes = signed_volumes(
      mesh.cut().mesh, {.of_face = of_face, .count = components.count}, mesh.component_boxes());
  const std::optional<Nesting> nesting = nesting_of_components(mesh, is_shell);
  for (std::size_t c = 0; c < components.count; ++c) {
    if (nesting) shells[c].inside = nesting->inside[c];
    if (is_shell[c] != 0 && std::isfinite(volumes[c].value)) {
      shells[c].volume = volumes[c].value;
    }
    if (nesting && is_shell[c] != 0 && volumes[c].sign != 0) {
      shells[c].outward = (volumes[c].sign > 0) == (nesting->depth[c] % 2 == 0);
    }
  }
  return shells;
}

std::vector<std::uint8_t> which_are_shells(const CutMesh& cut, const Components& components) {
  std::vector<std::uint8_t> is_shell(components.count, 1);
  const auto rule_out = [&](Index component) {
    std::atomic_ref(is_shell[component]).store(0, std::memory_order_relaxed);
  };
  // Borders of the cut mesh are borders of the complex, and edges that are not manifold or not
  // consistent.
  parallel_chunks(cut.mesh.n_halfedges(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const HalfedgeHandle h(static_cast<int>(i));
      if (cut.mesh.is_boundary(h)) rule_out(components.of(cut.mesh, h));
    }
  });
  for (const Index v : cut.side.non_manifold_vertices) {
    rule_out(components.of(cut.mesh, cut.mesh.halfedge_handle(VertexHandle(static_cast<int>(v)))));
  }
  return is_shell;
}

}  // namespace meshalyzer
