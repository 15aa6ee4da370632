#include "meshalyzer/geometry/curvature.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/geometry/corner_shares.h"
#include "meshalyzer/geometry/face_shape.h"
#include "meshalyzer/geometry/fan_sums.h"
#include "meshalyzer/geometry/principal_curvature.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

VertexHandle handle(std::size_t v) {
  return VertexHandle(static_cast<int>(v));
}

/// Returns the file's vertices at the two ends of an edge.
std::array<Index, 2> ends(const CutMesh& cut, HalfedgeHandle h) {
  return {cut.side.vertex(cut.mesh.from_vertex_handle(h)),
          cut.side.vertex(cut.mesh.to_vertex_handle(h))};
}

void take_off_surplus(const CutMesh& cut, const CutEdges& edges, std::vector<int>& beyond) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto halfedges = edges[i].halfedges;
    for (const Index v : ends(cut, halfedges[0])) {
      beyond[v] -= static_cast<int>(halfedges.size()) - 1;
    }
  }
}

/// Tells for each of the file's vertices whether it can have a curvature; never NoArea.
///
/// @return     #file vertices. Where it is Defined, the vertex is one of the mesh's with a closed
/// fan.
/// @complexity O(#V).
std::vector<CurvatureState> curvature_states(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  std::vector<CurvatureState> states(cut.side.n_file_vertices, CurvatureState::Defined);
  parallel_chunks(states.size(), [&](Chunk chunk) {
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      if (mesh.is_isolated(handle(v))) {
        states[v] = CurvatureState::Unused;
      } else if (mesh.is_boundary(handle(v))) {
        states[v] = CurvatureState::Border;
      }
    }
  });
  for (const Index v : cut.side.non_manifold_vertices) {
    states[v] = CurvatureState::NotOneFan;
  }
  for (std::size_t i = 0; i < cut.side.flipped_edges.size(); ++i) {
    for (const Index v : ends(cut, cut.side.flipped_edges[i].halfedges[0])) {
      states[v] = CurvatureState::NotOneFan;
    }
  }
  return states;
}

/// Returns the number of edges minus the number of faces at each of the file's vertices: 0 for
/// closed fans, 1 for each open fan, less if fans have edges in common.
///
/// @return     #file vertices.
/// @complexity O(#V).
std::vector<int> edges_beyond_faces(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  std::vector<int> beyond(cut.side.n_file_vertices, 0);
  const auto is_open = [&](std::size_t v) {
    return !mesh.is_isolated(handle(v)) && mesh.is_boundary(handle(v));
  };
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    if (is_open(v)) ++beyond[cut.side.vertex(handle(v))];
  }
  take_off_surplus(cut, cut.side.flipped_edges, beyond);
  take_off_surplus(cut, cut.side.non_manifold_edges, beyond);
  return beyond;
}

using AreaName = std::pair<VertexArea, std::string_view>;
constexpr std::array kAreaNames{
    AreaName{VertexArea::Mixed, "mixed"}, AreaName{VertexArea::Voronoi, "voronoi"},
    AreaName{VertexArea::Barycentric, "barycentric"}, AreaName{VertexArea::OneRing, "one-ring"}};

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

Curvature without_figures(std::vector<CurvatureState> state) {
  const std::size_t n = state.size();
  return {.state = std::move(state),
          .angle_defect = std::vector<double>(n),
          .area = std::vector<double>(n, kNoValue),
          .gaussian = std::vector<double>(n, kNoValue),
          .mean = std::vector<double>(n, kNoValue),
          .k1 = std::vector<double>(n, kNoValue),
          .k2 = std::vector<double>(n, kNoValue),
          .direction1 = std::vector<Vec3>(n, Vec3::Zero()),
          .direction2 = std::vector<Vec3>(n, Vec3::Zero())};
}

/// Adds the angles and areas of a vertex's copies to its own.
void gather_copies(const SideTable& side, std::vector<FanSums>& sums) {
  for (std::size_t i = 0; i < side.copies.size(); ++i) {
    const FanSums& copy = sums[side.n_file_vertices + i];
    sums[side.copies[i]].angle += copy.angle;
    sums[side.copies[i]].area += copy.area;
  }
}

/// Returns half the length of the cotangent vector over 2 A, with the sign of its direction against
/// the normal.
double mean_curvature(const FanSums& sums) {
  const double size = sums.cotangent.stableNorm() / sums.area / 4;
  return sums.cotangent.dot(sums.normal) < 0.0 ? -size : size;
}

/// Sets the figures of a vertex with one closed fan, or the state that says why there are none.
void set_curvature(const FanSums& sums, const PrincipalCurvature& principal, std::size_t v,
                   Curvature& curvature) {
  const double gaussian = curvature.angle_defect[v] / sums.area;
  const double mean = mean_curvature(sums);
  const bool is_defined = sums.area > 0.0 && std::isfinite(sums.area) && sums.has_normal() &&
                          std::isfinite(gaussian) && std::isfinite(mean) &&
                          std::isfinite(principal.k1) && std::isfinite(principal.k2);
  if (!is_defined) {
    curvature.state[v] = CurvatureState::NoArea;
    return;
  }
  curvature.gaussian[v] = gaussian;
  curvature.mean[v] = mean;
  curvature.k1[v] = principal.k1;
  curvature.k2[v] = principal.k2;
  curvature.direction1[v] = principal.direction1;
  curvature.direction2[v] = principal.direction2;
}

}  // namespace

std::string_view area_name(VertexArea area) {
  for (const auto& [value, name] : kAreaNames) {
    if (value == area) return name;
  }
  return {};
}

std::optional<VertexArea> vertex_area(std::string_view name) {
  for (const auto& [value, its_name] : kAreaNames) {
    if (its_name == name) return value;
  }
  return std::nullopt;
}

Curvature measure_curvature(const CutMesh& cut, VertexArea area) {
  const std::vector<FaceShape> shapes = measure_face_shapes(cut.mesh);
  const std::vector<CornerShares> mixed = corner_shares(cut.mesh, shapes, VertexArea::Mixed);
  std::vector<FanSums> sums =
      area == VertexArea::Mixed ? sum_fans(cut.mesh, shapes, mixed)
                                : sum_fans(cut.mesh, shapes, corner_shares(cut.mesh, shapes, area));
  gather_copies(cut.side, sums);
  const auto principal = principal_curvatures(cut.mesh, shapes, sums, mixed);
  const std::vector<int> edges_beyond = edges_beyond_faces(cut);
  Curvature curvature = without_figures(curvature_states(cut));
  parallel_chunks(cut.side.n_file_vertices, [&](Chunk chunk) {
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      curvature.angle_defect[v] = (2 - edges_beyond[v]) * std::numbers::pi - sums[v].angle;
      if (curvature.state[v] != CurvatureState::Unused) curvature.area[v] = sums[v].area;
      if (curvature.state[v] == CurvatureState::Defined) {
        set_curvature(sums[v], principal[v], v, curvature);
      }
    }
  });
  return curvature;
}

}  // namespace meshalyzer
