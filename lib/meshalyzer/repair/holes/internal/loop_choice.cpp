#include "meshalyzer/repair/holes/internal/loop_choice.h"

#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/spatial/triangle_distance.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

namespace meshalyzer {
namespace {

/// Returns the distance of a point from the nearest edge between a face that filled a hole and one
/// that did not.
double distance_from_patches(const PassInput& input, const Vec3& point) {
  const CutMesh& cut = input.mesh.cut();
  const auto fills_hole = [&](HalfedgeHandle h) {
    const FaceHandle f = cut.mesh.face_handle(h);
    return input.tracked.origin_of_face(cut.side.face(f)) == kNoIndex;
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (const EdgeHandle e : cut.mesh.edges()) {
    const HalfedgeHandle h = cut.mesh.halfedge_handle(e, 0);
    if (cut.mesh.is_boundary(e) ||
        fills_hole(h) == fills_hole(cut.mesh.opposite_halfedge_handle(h))) {
      continue;
    }
    const Vec3& a = cut.mesh.point(cut.mesh.from_vertex_handle(h));
    const Vec3& b = cut.mesh.point(cut.mesh.to_vertex_handle(h));
    nearest = std::min(nearest, distance_from_segment(a, b, point));
  }
  return nearest;
}

/// Refuses all loops that are not chosen.
void refuse_others(const PreparedMesh& mesh, std::span<const HoleLoop> loops,
                   const std::string& reason, LoopChoice& choice) {
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (choice.is_chosen[i] == 0) choice.refused.push_back(refuse_hole(mesh, loops[i], reason));
  }
}

/// Keeps only the loop nearest to a point; none if a still nearer one was filled before.
void choose_nearest(const PassInput& input, std::span<const HoleLoop> loops, const Vec3& point,
                    LoopChoice& choice) {
  std::vector<double> distances;
  for (const HoleLoop& loop : loops) {
    distances.push_back(distance_from(input.mesh.soup(), loop, point));
  }
  const auto nearest = std::min_element(distances.begin(), distances.end());
  choice.is_chosen.assign(loops.size(), 0);
  if (*nearest < distance_from_patches(input, point)) {
    choice.is_chosen[static_cast<std::size_t>(nearest - distances.begin())] = 1;
  }
  refuse_others(input.mesh, loops, "another hole is nearer to the point that was asked for",
                choice);
}

/// Removes the loops of sheets.
void refuse_sheets(const PassInput& input, std::span<const HoleLoop> loops, LoopChoice& choice) {
  const PreparedMesh& mesh = input.mesh;
  const Components components = find_edge_components(mesh.cut());
  const std::vector<std::uint8_t> is_solid = bounds_solid(mesh, components, input.wants_to_stop);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Index component = components.of(mesh.cut().mesh, loops[i].halfedges.front());
    if (is_solid[component] != 0) choice.may_be_sheet[i] = 0;
    if (choice.is_chosen[i] == 0 || is_solid[component] != 0) continue;
    choice.is_chosen[i] = 0;
    choice.refused.push_back(
        refuse_hole(mesh, loops[i],
                    "the surface is a sheet: it is left open unless hole filling is asked for by "
                    "name"));
  }
}

}  // namespace

LoopChoice choose_loops(const PassInput& input, std::span<const HoleLoop> loops,
                        const FillOptions& options) {
  LoopChoice choice{.is_chosen = std::vector<std::uint8_t>(loops.size(), 1),
                    .may_join = std::vector<std::uint8_t>(loops.size(), 1),
                    .may_be_sheet = std::vector<std::uint8_t>(loops.size(), 1),
                    .refused = {}};
  if (options.at) choose_nearest(input, loops, *options.at, choice);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].size() <= options.max_edges) continue;
    if (choice.is_chosen[i] != 0) {
      choice.refused.push_back(
          refuse_hole(input.mesh, loops[i], "it has more edges than the holes to be filled"));
    }
    choice.is_chosen[i] = 0;
    choice.may_join[i] = 0;
  }
  const bool is_any_left =
      std::find(choice.is_chosen.begin(), choice.is_chosen.end(), 1) != choice.is_chosen.end();
  if (options.sheets == FillSheets::No && is_any_left) refuse_sheets(input, loops, choice);
  return choice;
}

}  // namespace meshalyzer
