#pragma once

#include "meshalyzer/exact/exact_point.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <compare>
#include <cstdint>

namespace meshalyzer {

/// Two vertices of a soup, by index: the ends of an edge, or two points of a line.
using VertexPair = std::array<Index, 2>;

/// The kind of a point: a vertex, or which lines and planes meet in it.
enum class PointKind : std::uint8_t { Vertex, LineAndPlane, TwoLines, ThreePlanes };

/// The construction of a point of an arrangement from vertices and faces of the input, never from
/// other constructed points. One point may have several names; a name stands for one point.
struct PointName {
  PointKind kind = PointKind::Vertex;
  /// TwoLines: the axis along which the lines are projected.
  Axis axis = Axis::X;
  /// Vertex: the vertex. LineAndPlane: two vertices and a face. TwoLines: two vertices each.
  /// ThreePlanes: three faces.
  std::array<Index, 4> of{kNoIndex, kNoIndex, kNoIndex, kNoIndex};

  friend auto operator<=>(const PointName&, const PointName&) = default;
};

[[nodiscard]] PointName vertex_name(Index vertex);
/// Names the point where the line through two vertices meets the plane of a face; the order of the
/// vertices does not matter.
[[nodiscard]] PointName line_and_plane_name(VertexPair line, Index face);
/// Names the point where two lines in one plane meet.
[[nodiscard]] PointName two_lines_name(VertexPair p, VertexPair q, Axis axis);
/// Names the point where the planes of three faces meet.
[[nodiscard]] PointName three_planes_name(std::array<Index, 3> faces);

[[nodiscard]] ExactPoint construct_point(const Soup& soup, const PointName& name);

}  // namespace meshalyzer
