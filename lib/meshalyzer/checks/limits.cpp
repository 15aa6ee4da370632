#include "meshalyzer/checks/limits.h"

#include "meshalyzer/base/enum_table.h"
#include "meshalyzer/base/require.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/geometry/edge_measures.h"
#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/mesh/complex_edges.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>

namespace meshalyzer {
namespace {

constexpr std::array<LimitInfo, kLimitKinds> kLimitTable{{
    {LimitKind::MinCornerAngle, "min-corner-angle", LimitSense::AtLeast, "smallest angle",
     " degrees", "the angles of faces, in degrees"},
    {LimitKind::MaxAspectRatio, "max-aspect-ratio", LimitSense::AtMost, "aspect ratio", "",
     "the aspect ratios of faces"},
    {LimitKind::MinEdgeAngle, "min-edge-angle", LimitSense::AtLeast, "angle", " degrees",
     "the angles at edges, in degrees: 180 is flat"},
    {LimitKind::MaxEdgeAngle, "max-edge-angle", LimitSense::AtMost, "angle", " degrees",
     "the angles at edges, in degrees: 180 is flat"},
    {LimitKind::MinEdgeLength, "min-edge-length", LimitSense::AtLeast, "length", "",
     "the lengths of edges"},
    {LimitKind::MaxEdgeLength, "max-edge-length", LimitSense::AtMost, "length", "",
     "the lengths of edges"},
    {LimitKind::MinFaces, "min-faces", LimitSense::AtLeast, "number of faces", "",
     "the number of faces; every profile asks for 1"},
    {LimitKind::MaxFaces, "max-faces", LimitSense::AtMost, "number of faces", "",
     "the number of faces"},
    {LimitKind::MaxComponents, "max-components", LimitSense::AtMost, "number of components", "",
     "the number of components"},
}};

static_assert(is_in_enum_order(kLimitTable, &LimitInfo::kind));

/// Tells which values are beyond a limit.
class Bound {
 public:
  Bound(LimitKind kind, double limit) : sense_(limit_info(kind).sense), limit_(limit) {}

  [[nodiscard]] bool is_passed_by(double value) const {
    return sense_ == LimitSense::AtLeast ? value < limit_ : value > limit_;
  }

 private:
  LimitSense sense_;
  double limit_;
};

using Violations = std::vector<LimitViolation>;

Violations faces_beyond(const CutMesh& cut, const std::vector<double>& values, const Bound& bound) {
  Violations found;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!bound.is_passed_by(values[i])) continue;
    const FaceHandle face(static_cast<int>(i));
    const Corners corners = face_corners(cut.mesh, face);
    found.push_back({.vertices = {},
                     .faces = {cut.side.face(face)},
                     .position = centroid_without_overflow(corners),
                     .value = values[i]});
  }
  return found;
}

LimitViolation at_edge(const CutMesh& cut, HalfedgeHandle halfedge, double value) {
  const TriMesh& mesh = cut.mesh;
  const auto [low, high] = ascending_file_ends(cut, halfedge);
  LimitViolation found{.vertices = {low, high},
                       .faces = {},
                       .position = mesh.point(mesh.from_vertex_handle(halfedge)) / 2 +
                                   mesh.point(mesh.to_vertex_handle(halfedge)) / 2,
                       .value = value};
  for (const HalfedgeHandle h : {halfedge, mesh.opposite_halfedge_handle(halfedge)}) {
    if (const FaceHandle f = mesh.face_handle(h); f.is_valid()) {
      found.faces.push_back(cut.side.face(f));
    }
  }
  std::sort(found.faces.begin(), found.faces.end());
  return found;
}

Violations edges_beyond(const CutMesh& cut, const std::vector<HalfedgeHandle>& edges,
                        const std::vector<double>& values, const Bound& bound) {
  Violations found;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (bound.is_passed_by(values[i])) found.push_back(at_edge(cut, edges[i], values[i]));
  }
  return found;
}

Violations lengths_beyond(const CutMesh& cut, const Bound& bound) {
  const std::vector<HalfedgeHandle> edges = complex_edges(cut);
  return edges_beyond(cut, edges, lengths_of(edges, mesh_edge_lengths(cut.mesh)), bound);
}

Violations angles_beyond(const CutMesh& cut, const Bound& bound) {
  const EdgeAngles angles = measure_edge_angles(cut.mesh, measure_faces(cut.mesh).zero_area);
  return edges_beyond(cut, angles.edges, angles.degrees, bound);
}

Violations mesh_beyond(std::size_t count, const Bound& bound) {
  const auto value = static_cast<double>(count);
  if (!bound.is_passed_by(value)) return {};
  return {{.vertices = {}, .faces = {}, .position = std::nullopt, .value = value}};
}

}  // namespace

std::span<const LimitInfo> limit_table() {
  return kLimitTable;
}

const LimitInfo& limit_info(LimitKind kind) {
  return kLimitTable[static_cast<std::size_t>(kind)];
}

std::optional<LimitKind> limit_kind(std::string_view name) {
  const auto* const found = std::find_if(kLimitTable.begin(), kLimitTable.end(),
                                         [&](const LimitInfo& info) { return info.name == name; });
  if (found == kLimitTable.end()) return std::nullopt;
  return found->kind;
}

std::vector<LimitViolation> find_beyond_limit(const PreparedMesh& mesh, LimitKind kind,
                                              double limit) {
  require_number(limit_info(kind).name, limit);
  const CutMesh& cut = mesh.cut();
  require_finite_positions(cut.mesh);
  const Bound bound(kind, limit);
  switch (kind) {
    case LimitKind::MinCornerAngle:
      return faces_beyond(cut, measure_faces(cut.mesh).corner_angle, bound);
    case LimitKind::MaxAspectRatio:
      return faces_beyond(cut, measure_faces(cut.mesh).aspect_ratio, bound);
    case LimitKind::MinEdgeAngle:
    case LimitKind::MaxEdgeAngle:
      return angles_beyond(cut, bound);
    case LimitKind::MinEdgeLength:
    case LimitKind::MaxEdgeLength:
      return lengths_beyond(cut, bound);
    case LimitKind::MinFaces:
    case LimitKind::MaxFaces:
      return mesh_beyond(mesh.soup().n_faces(), bound);
    case LimitKind::MaxComponents:
      return mesh_beyond(mesh.components().count, bound);
  }
  return {};
}

}  // namespace meshalyzer
