#include "meshalyzer/boolean/part_from.h"

#include "meshalyzer/base/require.h"
#include "meshalyzer/boolean/internal/blocking_faces.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/direction_off.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace meshalyzer {
namespace {

/// The first step, as a share of the largest coordinate: at least 64 units in its last place.
constexpr double kFirstShare = 0x1p-46;
constexpr double kStepGrowth = 4.0;
constexpr int kMostRounds = 24;
/// A vertex is on a face if the distance is at most this many first steps.
constexpr double kNearSteps = 8.0;

/// Moves vertices, round by round, farther away where faces still meet.
class PartingFrom {
 public:
  PartingFrom(const CombinedSolid& difference, const Soup& others, double max_move)
      : start_(difference.positions),
        others_(others),
        cut_others_(build(others)),
        tree_of_others_(cut_others_),
        max_move_(max_move) {
    soup_.positions = difference.positions;
    double size = 0.0;
    for (const CombinedFace& face : difference.faces) {
      soup_.triangles.push_back(face.corners);
      for (const Index v : face.corners) size = std::max(size, start_[v].cwiseAbs().maxCoeff());
    }
    first_step_ = kFirstShare * size;
  }

  PartedVertices run(const CombinedSolid& difference, const Operands& operands) {
    const std::vector<IntersectingPair> touching = find_pairs();
    if (touching.empty()) return {};
    for (const CombinedFace& face : difference.faces) add_wall(face, operands);
    std::vector<IntersectingPair> pairs = touching;
    for (int round = 0; round < kMostRounds && !pairs.empty(); ++round) {
      choose(pairs);
      if (!move()) break;
      pairs = find_pairs();
    }
    PartedVertices parted = moved_vertices();
    parted.n_pairs_left = pairs.size();
    parted.blocking = find_blocking_faces({soup_, start_, others_, touching, pairs, near()});
    return parted;
  }

 private:
  /// A vertex that is on the other operands, and how far it must leave their faces.
  struct Contact {
    /// The unit normals of common walls, pointing out of the others.
    std::vector<Vec3> walls;
    /// The unit normals of faces that it touches.
    std::vector<Vec3> touched;
    double step = 0.0;
    bool is_to_grow = false;
  };

  [[nodiscard]] std::vector<IntersectingPair> find_pairs() const {
    const CutMesh cut = build(soup_);
    return find_intersections(cut, FaceTree(cut), cut_others_, tree_of_others_);
  }

  /// Records a face that is a part of a face of the others, or lies on one. The faces of pads,
  /// which come after those of the operands, are no walls.
  void add_wall(const CombinedFace& face, const Operands& operands) {
    if (face.origin >= operands.of_face.size()) return;
    const bool is_of_others = operands.of_face[face.origin] != 0;
    if (!is_of_others && !face.is_common) return;
    const auto [a, b, c] = corners_of(operands.soup, face.origin);
    const Vec3 normal = is_of_others ? accurate_normal(a, b, c) : accurate_normal(a, c, b);
    for (const Index v : face.corners) add_normal(normal, contacts_[v].walls);
  }

  /// Chooses the vertices that must move farther: of each face that meets another one the vertices
  /// that are on that face, or nearest to it.
  void choose(const std::vector<IntersectingPair>& pairs) {
    for (const IntersectingPair& pair : pairs) {
      const Triangle& t = soup_.triangles[pair.face_a];
      const Corners other = corners_of(others_, pair.face_b);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Index v : t) {
        if (has_wall(v)) nearest = std::min(nearest, distance(other, v));
      }
      const bool has_no_wall = std::isinf(nearest);
      for (const Index v : t) {
        const double away = distance(other, v);
        if (away > std::max(has_no_wall ? 0.0 : nearest, near())) continue;
        Contact& contact = contacts_[v];
        contact.is_to_grow = true;
        if (!contact.walls.empty() && away > near()) continue;
        add_normal(accurate_normal(other[0], other[1], other[2]), contact.touched);
      }
    }
  }

  [[nodiscard]] bool has_wall(Index vertex) const {
    const auto found = contacts_.find(vertex);
    return found != contacts_.end() && !found->second.walls.empty();
  }

  [[nodiscard]] double near() const { return kNearSteps * first_step_; }

  [[nodiscard]] double distance(const Corners& other, Index vertex) const {
    return closest_on_triangle(other, start_[vertex]).distance;
  }

  /// Adds a normal; faces of one plane count once.
  static void add_normal(const Vec3& scaled, std::vector<Vec3>& normals) {
    if (!(scaled.stableNorm() > 0.0)) return;
    const Vec3 normal = scaled.stableNormalized();
    if (std::find(normals.begin(), normals.end(), normal) == normals.end()) {
      normals.push_back(normal);
    }
  }

  /// Moves the vertices of which faces still meet others.
  /// @return True if any vertex can move farther.
  bool move() {
    bool is_any = false;
    for (auto& [vertex, contact] : contacts_) {
      if (!std::exchange(contact.is_to_grow, false)) continue;
      const DirectionOff off = way_off(contact);
      if (!is_way_off(off)) continue;
      contact.step = contact.step == 0.0 ? first_step_ : kStepGrowth * contact.step;
      const Vec3 to =
          start_[vertex] + std::min(contact.step / off.clearance, max_move_) * off.direction;
      is_any = is_any || to != soup_.positions[vertex];
      soup_.positions[vertex] = to;
    }
    return is_any;
  }

  /// Tells whether a direction leads off faces within the largest distance.
  [[nodiscard]] bool is_way_off(const DirectionOff& off) const {
    return off.clearance * max_move_ > first_step_;
  }

  /// Returns the direction that leaves all faces at a vertex or, where none does, the walls.
  [[nodiscard]] DirectionOff way_off(const Contact& contact) const {
    std::vector<Vec3> normals = contact.walls;
    for (const Vec3& normal : contact.touched) add_normal(normal, normals);
    if (normals.empty()) return {};
    const DirectionOff off = direction_off(normals);
    if (contact.walls.empty() || is_way_off(off)) return off;
    return direction_off(contact.walls);
  }

  [[nodiscard]] PartedVertices moved_vertices() const {
    PartedVertices parted;
    for (const auto& [vertex, contact] : contacts_) {
      if (soup_.positions[vertex] == start_[vertex]) continue;
      parted.vertices.push_back(vertex);
      parted.positions.push_back(soup_.positions[vertex]);
      parted.largest_move =
          std::max(parted.largest_move, (soup_.positions[vertex] - start_[vertex]).stableNorm());
    }
    return parted;
  }

  std::vector<Vec3> start_;
  const Soup& others_;
  CutMesh cut_others_;
  FaceTree tree_of_others_;
  double max_move_;
  double first_step_ = 0.0;
  /// The current mesh, with positions and faces only.
  Soup soup_;
  std::map<Index, Contact> contacts_;
};

}  // namespace

PartedVertices part_from(const CombinedSolid& difference, const Operands& operands,
                         const Soup& others, double max_move) {
  require_length("the largest distance of a move", max_move);
  return PartingFrom(difference, others, max_move).run(difference, operands);
}

}  // namespace meshalyzer
