#include "meshalyzer/arrangement/point_name.h"

#include "meshalyzer/exact/meet.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

VertexPair ascending(const VertexPair& pair) {
  return {std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
}

LinePoints line_through(const Soup& soup, Index a, Index b) {
  return {soup.positions[a], soup.positions[b]};
}

}  // namespace

PointName vertex_name(Index vertex) {
  return {.kind = PointKind::Vertex, .of = {vertex, kNoIndex, kNoIndex, kNoIndex}};
}

PointName line_and_plane_name(VertexPair line, Index face) {
  line = ascending(line);
  return {.kind = PointKind::LineAndPlane, .of = {line[0], line[1], face, kNoIndex}};
}

PointName two_lines_name(VertexPair p, VertexPair q, Axis axis) {
  p = ascending(p);
  q = ascending(q);
  if (q < p) std::swap(p, q);
  return {.kind = PointKind::TwoLines, .axis = axis, .of = {p[0], p[1], q[0], q[1]}};
}

PointName three_planes_name(std::array<Index, 3> faces) {
  std::sort(faces.begin(), faces.end());
  return {.kind = PointKind::ThreePlanes, .of = {faces[0], faces[1], faces[2], kNoIndex}};
}

ExactPoint construct_point(const Soup& soup, const PointName& name) {
  const auto& of = name.of;
  switch (name.kind) {
    case PointKind::LineAndPlane:
      return meet(line_through(soup, of[0], of[1]), corners_of(soup, of[2]));
    case PointKind::TwoLines:
      return meet(line_through(soup, of[0], of[1]), line_through(soup, of[2], of[3]), name.axis);
    case PointKind::ThreePlanes:
      return meet(corners_of(soup, of[0]), corners_of(soup, of[1]), corners_of(soup, of[2]));
    case PointKind::Vertex:
      break;
  }
  return exact_point(soup.positions[of[0]]);
}

}  // namespace meshalyzer
