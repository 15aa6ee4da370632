#include "meshalyzer/repair/split/internal/moved_faces.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/rules/internal/contact_rule.h"
#include "meshalyzer/repair/rules/internal/orientation_rule.h"
#include "meshalyzer/spatial/align_faces.h"
#include "meshalyzer/spatial/faces_meeting_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

/// The number of pairs of faces that is always checked, in addition to pairs of moving faces.
constexpr std::size_t kFreePairs = 4096;
/// As many times more pairs may have boxes that meet: long, thin faces have large ones.
constexpr std::size_t kMeetingBoxes = 8;
/// In the time of one check so many pairs with boxes that meet can be compared with slabs.
constexpr std::size_t kTestsInACheck = 16;
/// Faces farther apart than this multiple of the reach cannot meet after a move: each coordinate
/// changes by the reach at most, and rounding of the distance is small beside it.
constexpr double kApart = 4.0;

/// The slabs round a face, each between two parallel planes: one along the face, and one along each
/// of its edges, upright on the face. All points within a distance of the face lie in all of them.
class FaceSlabs {
 public:
  FaceSlabs(const Corners& face, double distance) : origin_(face[0]) {
    const Vec3 normal = normal_of(face);
    add(normal, face, distance);
    for (std::size_t i = 0; i < 3; ++i) {
      add((face.at((i + 1) % 3) - face.at(i)).cross(normal), face, distance);
    }
  }

  /// Tells whether another face lies on one side of a slab, so that it is farther away than the
  /// distance.
  [[nodiscard]] bool is_beside(const Corners& other) const {
    const Corners relative{other[0] - origin_, other[1] - origin_, other[2] - origin_};
    return std::any_of(slabs_.begin(), slabs_.begin() + n_slabs_, [&](const Slab& slab) {
      const std::array<double, 3> at{slab.direction.dot(relative[0]),
                                     slab.direction.dot(relative[1]),
                                     slab.direction.dot(relative[2])};
      // If a product overflows to NaN, nothing is proved.
      return (at[0] > slab.high && at[1] > slab.high && at[2] > slab.high) ||
             (at[0] < slab.low && at[1] < slab.low && at[2] < slab.low);
    });
  }

 private:
  struct Slab {
    /// The unit normal of the planes.
    Vec3 direction;
    /// Where the planes are in this direction, from the first corner of the face on.
    double low = 0.0;
    double high = 0.0;
  };

  void add(const Vec3& direction, const Corners& face, double distance) {
    const double length = direction.norm();
    if (!(length > 0.0 && std::isfinite(length))) return;
    Slab slab{direction / length, 0.0, 0.0};
    for (const Vec3& corner : face) {
      const double at = slab.direction.dot(corner - origin_);
      slab.low = std::min(slab.low, at);
      slab.high = std::max(slab.high, at);
    }
    slab.low -= distance;
    slab.high += distance;
    slabs_.at(n_slabs_++) = slab;
  }

  Vec3 origin_;
  std::array<Slab, 4> slabs_;
  std::size_t n_slabs_ = 0;
};

}  // namespace

void MovedMesh::move(std::span<const Index> vertices, const Vec3& to) {
  for (const Index v : vertices) {
    reach_ = std::max(reach_, (to - positions_[v]).cwiseAbs().maxCoeff());
    positions_[v] = to;
  }
}

std::vector<Index> MovedMesh::faces_near(const Box3& box) const {
  std::vector<Index> faces = find_faces_meeting(mesh_.tree(), grown(box, 2 * reach_));
  for (Index& f : faces) f = mesh_.cut().side.faces[f];
  return faces;
}

Move::Move(const MovedMesh& mesh, std::span<const Index> vertices, std::span<const Index> faces,
           double reach)
    : mesh_(mesh), vertices_(vertices), faces_(faces) {
  const std::size_t max_pairs = kFreePairs + faces.size() * faces.size();
  std::size_t n_meeting = 0;
  const auto box = [&](Index face) { return box_of(mesh_.corners(mesh_.triangle(face))); };
  for (const Index face : faces_) region_.extend(box(face));
  region_ = grown(region_, reach);
  const std::vector<Index> others = mesh_.faces_near(region_);
  std::vector<Box3> boxes(others.size());
  std::transform(others.begin(), others.end(), boxes.begin(), box);
  for (const Index face : faces_) {
    const Corners corners = mesh_.corners(mesh_.triangle(face));
    const Box3 near = grown(box_of(corners), reach);
    const FaceSlabs slabs(corners, kApart * reach);
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (!near.intersects(boxes[i])) continue;
      const bool moves_too = std::binary_search(faces_.begin(), faces_.end(), others[i]);
      if (moves_too && others[i] <= face) continue;
      ++n_meeting;
      const Corners other = mesh_.corners(mesh_.triangle(others[i]));
      if (moves_too || !slabs.is_beside(other)) pairs_.push_back({face, others[i]});
    }
    is_crowded_ = pairs_.size() > max_pairs || n_meeting > kMeetingBoxes * max_pairs;
    n_checks_to_find_ = n_meeting / kTestsInACheck;
    if (is_crowded_) return;
  }
  std::sort(pairs_.begin(), pairs_.end());
  std::stable_partition(pairs_.begin(), pairs_.end(),
                        [&](const Pair& pair) { return is_at_place(pair[1]); });
}

bool Move::is_accepted(const Vec3& to, std::size_t& n_checks_left) {
  if (is_crowded_) return false;
  for (const Index face : faces_) {
    if (!keeps_its_side(mesh_.triangle(face), to)) return false;
  }
  for (std::size_t i = 0; i < pairs_.size();) {
    if (n_checks_left == 0) return false;
    --n_checks_left;
    if (!would_touch(pairs_[i], to)) {
      ++i;
    } else if (touched_before(pairs_[i])) {
      pairs_[i] = pairs_.back();
      pairs_.pop_back();
    } else {
      std::swap(pairs_[i], pairs_.front());
      return false;
    }
  }
  return true;
}

bool Move::is_moving(Index vertex) const {
  return std::binary_search(vertices_.begin(), vertices_.end(), vertex);
}

/// Tells whether a face has a corner at the position of the vertices, but none of them.
bool Move::is_at_place(Index face) const {
  const Triangle& t = mesh_.triangle(face);
  return std::any_of(t.begin(), t.end(), [&](Index v) {
    return !is_moving(v) && mesh_.position(v) == mesh_.position(vertices_.front());
  });
}

Corners Move::moved_corners(const Triangle& t, const Vec3& to) const {
  Corners corners = mesh_.corners(t);
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_moving(t[i])) corners[i] = to;
  }
  return corners;
}

bool Move::keeps_its_side(const Triangle& t, const Vec3& to) const {
  return keeps_orientation(mesh_.corners(t), moved_corners(t, to));
}

bool Move::would_touch(const Pair& pair, const Vec3& to) const {
  const auto is_one = [&](Index a, Index b) {
    return a == b || (!is_moving(a) && !is_moving(b) && mesh_.position(a) == mesh_.position(b));
  };
  const Triangle& p = mesh_.triangle(pair[0]);
  const Triangle& q = mesh_.triangle(pair[1]);
  return are_in_contact({p, moved_corners(p, to)}, {q, moved_corners(q, to)}, is_one);
}

bool Move::touched_before(const Pair& pair) const {
  const auto is_one = [&](Index a, Index b) {
    return a == b || mesh_.position(a) == mesh_.position(b);
  };
  const auto [p, q, n_common] =
      align_faces(mesh_.triangle(pair[0]), mesh_.triangle(pair[1]), is_one);
  // Faces that coincide, corner on corner, are to be parted too.
  if (n_common == 3) return p == q;
  return find_contact(mesh_.corners(p), mesh_.corners(q), static_cast<Common>(n_common))
      .has_value();
}

}  // namespace meshalyzer
