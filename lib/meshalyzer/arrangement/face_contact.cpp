#include "meshalyzer/arrangement/face_contact.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// The relative position of two faces.
enum class Position : std::uint8_t {
  /// The faces are two triangles in different planes, or a triangle and a segment not in its plane.
  Askew,
  /// The faces are two coplanar triangles.
  CoplanarTriangles,
  /// The faces are coplanar, and one of them is a segment or a point.
  Flat,
};

/// Collects the points where two faces meet.
class Meeting {
 public:
  Meeting(const Soup& soup, const FaceSimplex& p, const FaceSimplex& q)
      : soup_(soup), p_(p), q_(q) {}

  void find() {
    position_ = position();
    add_corners(p_, q_);
    add_corners(q_, p_);
    if (position_ == Position::Askew) {
      add_piercings(p_, q_);
      add_piercings(q_, p_);
    } else if (const auto axis = common_axis()) {
      add_crossings(*axis);
    }
  }

  void report(FaceContacts& found) const {
    for (const PointName& point : points_) {
      found.points.push_back({p_.face, point});
      found.points.push_back({q_.face, point});
    }
    if (position_ == Position::CoplanarTriangles) {
      report_edges(p_, found);
      report_edges(q_, found);
    } else {
      report_segments(points_, p_, q_, found);
      report_segments(points_, q_, p_, found);
    }
  }

 private:
  [[nodiscard]] const Vec3& at(Index vertex) const { return soup_.positions[vertex]; }

  [[nodiscard]] bool is_in_plane(const FaceSimplex& triangle, const FaceSimplex& other) const {
    return std::all_of(other.vertices.begin(), other.vertices.end(),
                       [&](Index x) { return side_of(soup_, triangle, x) == 0; });
  }

  [[nodiscard]] Position position() const {
    if (p_.is_triangle() && q_.is_triangle()) {
      return is_in_plane(p_, q_) ? Position::CoplanarTriangles : Position::Askew;
    }
    const bool askew =
        (p_.is_triangle() && !is_in_plane(p_, q_)) || (q_.is_triangle() && !is_in_plane(q_, p_));
    return askew ? Position::Askew : Position::Flat;
  }

  /// Returns an axis along which the common plane projects to non-zero area, or nothing if none of
  /// their edges can cross.
  [[nodiscard]] std::optional<Axis> common_axis() const {
    if (p_.is_triangle()) return p_.axis;
    if (q_.is_triangle()) return q_.axis;
    if (p_.dimension == 0 || q_.dimension == 0) return std::nullopt;
    const auto [a, b] = p_.ends;
    const auto [c, d] = q_.ends;
    if (orient3d(at(a), at(b), at(c), at(d)) != 0) return std::nullopt;
    return projection_axis(at(a), at(b), at(c));
  }

  void add_corners(const FaceSimplex& of, const FaceSimplex& in) {
    for (const Index x : of.vertices) {
      if (contains(soup_, in, x)) add(vertex_name(x));
    }
  }

  void add(const PointName& point) {
    if (std::find(points_.begin(), points_.end(), point) == points_.end()) {
      points_.push_back(point);
    }
  }

  /// Adds the points, other than corners, where edges pass through a triangle from one side of its
  /// plane to the other.
  void add_piercings(const FaceSimplex& of, const FaceSimplex& triangle) {
    if (!triangle.is_triangle()) return;
    for (const VertexPair& edge : of.edges()) {
      if (side_of(soup_, triangle, edge[0]) * side_of(soup_, triangle, edge[1]) < 0 &&
          pierces(edge, triangle)) {
        add(line_and_plane_name(edge, triangle.face));
      }
    }
  }

  /// Tells whether a line that is not in the plane of the triangle passes through its interior, or
  /// through the interior of an edge.
  [[nodiscard]] bool pierces(const VertexPair& edge, const FaceSimplex& triangle) const {
    Sign side = 0;
    int n_zeros = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = triangle.vertices[i];
      const Index v = triangle.vertices[(i + 1) % 3];
      const Sign turn = around(edge, u, v);
      if (turn == 0) {
        ++n_zeros;
      } else if (turn * side < 0) {
        return false;
      } else {
        side = turn;
      }
    }
    return n_zeros < 2;
  }

  [[nodiscard]] Sign around(const VertexPair& edge, Index u, Index v) const {
    const bool common = u == edge[0] || u == edge[1] || v == edge[0] || v == edge[1];
    return common ? 0 : orient3d(at(edge[0]), at(edge[1]), at(u), at(v));
  }

  void add_crossings(Axis axis) {
    for (const VertexPair& e : p_.edges()) {
      for (const VertexPair& f : q_.edges()) {
        if (separates(axis, e, f) && separates(axis, f, e)) add(two_lines_name(e, f, axis));
      }
    }
  }

  /// Tells whether the ends of an edge lie strictly on different sides of a line.
  [[nodiscard]] bool separates(Axis axis, const VertexPair& line, const VertexPair& edge) const {
    const auto side = [&](Index x) {
      return x == line[0] || x == line[1] ? 0 : orient2d(axis, at(line[0]), at(line[1]), at(x));
    };
    return side(edge[0]) * side(edge[1]) < 0;
  }

  [[nodiscard]] bool is_on(const VertexPair& edge, const PointName& point) const {
    if (point.kind == PointKind::Vertex) return is_on_segment(soup_, edge, point.of[0]);
    const VertexPair key{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
    return key == VertexPair{point.of[0], point.of[1]} ||
           key == VertexPair{point.of[2], point.of[3]};
  }

  /// Reports the parts of a triangle's edges that lie in the other, coplanar triangle.
  void report_edges(const FaceSimplex& of, FaceContacts& found) const {
    for (const VertexPair& edge : of.edges()) {
      std::vector<PointName> on;
      std::copy_if(points_.begin(), points_.end(), std::back_inserter(on),
                   [&](const PointName& point) { return is_on(edge, point); });
      report_segments(on, p_, q_, found);
      report_segments(on, q_, p_, found);
    }
  }

  /// Reports the segments from the first of collinear points to the others, which cover everything
  /// between them.
  void report_segments(const std::vector<PointName>& points, const FaceSimplex& face,
                       const FaceSimplex& other, FaceContacts& found) const {
    if (!face.is_triangle()) return;
    for (std::size_t i = 1; i < points.size(); ++i) {
      found.segments.push_back({face.face, other.face, line(other), points[0], points[i]});
    }
  }

  [[nodiscard]] SegmentLine line(const FaceSimplex& other) const {
    if (position_ == Position::CoplanarTriangles) return SegmentLine::Edge;
    return other.is_triangle() ? SegmentLine::Plane : SegmentLine::Face;
  }

  const Soup& soup_;
  const FaceSimplex& p_;
  const FaceSimplex& q_;
  Position position_ = Position::Askew;
  std::vector<PointName> points_;
};

}  // namespace

void find_face_contact(const Soup& soup, const FaceSimplex& p, const FaceSimplex& q,
                       FaceContacts& found) {
  Meeting meeting(soup, p, q);
  meeting.find();
  meeting.report(found);
}

}  // namespace meshalyzer
