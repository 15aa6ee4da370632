#include "meshalyzer/spatial/ray_parity.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/spatial/triangle_contact.h"
#include "meshalyzer/spatial/visit_meeting.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

Sign sign_of_difference(double a, double b) {
  return static_cast<Sign>(a > b) - static_cast<Sign>(a < b);
}

/// Tells on which side of the line u v the displaced point lies, in the projection along x; 0 only
/// if u and v project to the same point.
Sign displaced_side(const Vec3& u, const Vec3& v, const Vec3& point) {
  if (const Sign side = orient2d(Axis::X, u, v, point)) {
    return side;
  }
  // The derivatives of the determinant with respect to the displacement decide: first along y, then
  // along z.
  if (const Sign along_y = sign_of_difference(u.z(), v.z())) {
    return along_y;
  }
  return sign_of_difference(v.y(), u.y());
}

/// Tells whether the ray meets a triangle on which the point does not lie.
bool is_met(const Corners& t, const Vec3& point) {
  const Sign turn = displaced_side(t[0], t[1], point);
  if (turn == 0 || displaced_side(t[1], t[2], point) != turn ||
      displaced_side(t[2], t[0], point) != turn) {
    return false;
  }
  // The normal of a triangle that is counter-clockwise along x points to larger x, so the triangle
  // lies ahead if the point is behind it.
  return orient3d(t[0], t[1], t[2], point) * turn < 0;
}

/// Collects the parts that one ray meets.
class Ray {
 public:
  Ray(const FaceTree& tree, const FaceParts& parts, const Vec3& point, double far_x)
      : tree_(tree), parts_(parts), point_(point), box_{tree.map(point), tree.map(point)} {
    box_.high[0] = tree.map({far_x, point.y(), point.z()})[0];
  }

  PointLocation follow() {
    visit_meeting(tree_, box_, [&](std::size_t slot) {
      meet_face(slot);
      return true;
    });
    return {odd_ones(std::move(met_)), distinct(std::move(on_))};
  }

 private:
  void meet_face(std::size_t slot) {
    const Corners corners = tree_.corners(slot);
    const Index part = parts_.of_face[tree_.mesh_face(slot)];
    if (find_contact({point_, point_, point_}, corners, Common::Nothing)) {
      on_.push_back(part);
    } else if (is_met(corners, point_)) {
      met_.push_back(part);
    }
  }

  static std::vector<Index> distinct(std::vector<Index> parts) {
    sort_unique(parts);
    return parts;
  }

  static std::vector<Index> odd_ones(std::vector<Index> parts) {
    std::sort(parts.begin(), parts.end());
    std::vector<Index> odd;
    for (auto begin = parts.begin(); begin != parts.end();) {
      const auto end = std::upper_bound(begin, parts.end(), *begin);
      if ((end - begin) % 2 == 1) {
        odd.push_back(*begin);
      }
      begin = end;
    }
    return odd;
  }

  const FaceTree& tree_;
  const FaceParts& parts_;
  Vec3 point_;
  TreeBox box_;
  std::vector<Index> met_;
  std::vector<Index> on_;
};

}  // namespace

PointLocation locate(const FaceTree& tree, const FaceParts& parts, const Vec3& point,
                     double far_x) {
  return Ray(tree, parts, point, far_x).follow();
}

}  // namespace meshalyzer
