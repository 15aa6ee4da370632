#include "meshalyzer/spatial/long_face_tree.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/long_face.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

/// A tree over fewer faces is searched sooner than made again.
constexpr std::size_t kFewestFaces = 512;
/// About so many faces are looked at.
constexpr std::size_t kFacesLookedAt = 512;
/// Of these, one share has to run along the axes, and another obliquely to those of the file.
constexpr double kLeastShare = 0.75;
constexpr double kLeastOblique = 0.25;
/// Directions are alike if the cosine of the angle between them is at least this, and perpendicular
/// if it is at most the other.
constexpr double kAlike = 0.99;
constexpr double kPerpendicular = 0.1;
/// A direction is oblique if its angle to each axis of the file has at least this sine.
constexpr double kLeastTilt = 0x1p-6;
/// Meshes of a size outside these bounds might overflow or underflow where places are computed.
constexpr double kSmallestMesh = 1e-100;
constexpr double kLargestMesh = 1e100;

/// Returns the direction of the longest side of a triangle.
Vec3 longest_direction(const Corners& t) {
  Vec3 longest = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = t[(i + 1) % 3] - t[i];
    if (side.squaredNorm() > longest.squaredNorm()) longest = side;
  }
  return longest.normalized();
}

bool are_alike(const Vec3& a, const Vec3& b) {
  return std::abs(a.dot(b)) >= kAlike;
}

/// Returns the mean of the directions that are like the one that most are like; zero if there are
/// none.
Vec3 most_common(std::span<const Vec3> directions) {
  std::ptrdiff_t most = 0;
  Vec3 found = Vec3::Zero();
  for (const Vec3& direction : directions) {
    const std::ptrdiff_t n =
        std::count_if(directions.begin(), directions.end(),
                      [&](const Vec3& other) { return are_alike(direction, other); });
    if (n > most) {
      most = n;
      found = direction;
    }
  }
  Vec3 sum = Vec3::Zero();
  for (const Vec3& direction : directions) {
    if (!are_alike(found, direction)) continue;
    sum += found.dot(direction) < 0.0 ? Vec3(-direction) : direction;
  }
  return sum.normalized();
}

/// Returns those parts of directions that are perpendicular to a given one, of those that nearly
/// are.
std::vector<Vec3> perpendicular_parts(std::span<const Vec3> directions, const Vec3& to) {
  std::vector<Vec3> parts;
  for (const Vec3& direction : directions) {
    const double along = direction.dot(to);
    if (std::abs(along) <= kPerpendicular) parts.push_back((direction - along * to).normalized());
  }
  return parts;
}

bool is_oblique(const Vec3& direction) {
  const double along = direction.cwiseAbs().maxCoeff();
  return 1.0 - along * along >= kLeastTilt * kLeastTilt;
}

/// The long faces of a sample: the directions of their longest sides, and their normals.
struct LongFaces {
  std::vector<Vec3> directions;
  std::vector<Vec3> normals;
  std::size_t n_sampled = 0;
};

LongFaces sample_of(const FaceTree& tree) {
  LongFaces found;
  const std::size_t step = tree.n_faces() / kFacesLookedAt | 1U;
  for (std::size_t slot = 0; slot < tree.n_faces(); slot += step) {
    const Corners face = tree.corners(slot);
    ++found.n_sampled;
    if (!is_long_face(face)) continue;
    found.directions.push_back(longest_direction(face));
    found.normals.push_back(normal_of(face).normalized());
  }
  return found;
}

/// Returns the axes that most long faces run along. A bundle along one direction has its normals
/// for the second.
BoxFrame frame_along(const LongFaces& faces, const Vec3& origin) {
  const Vec3 first = most_common(faces.directions);
  Vec3 second = most_common(perpendicular_parts(faces.directions, first));
  if (second.isZero()) second = most_common(perpendicular_parts(faces.normals, first));
  if (second.isZero()) second = first.unitOrthogonal();
  BoxFrame frame{.origin = origin};
  frame.axes.row(0) = first;
  frame.axes.row(1) = second;
  frame.axes.row(2) = first.cross(second);
  return frame;
}

/// Tells whether most faces of a sample run along the axes, and many obliquely to those of the
/// file.
bool fits(const BoxFrame& frame, const LongFaces& faces) {
  std::size_t n_along = 0;
  std::size_t n_oblique = 0;
  for (const Vec3& direction : faces.directions) {
    Eigen::Index axis = 0;
    if ((frame.axes * direction).cwiseAbs().maxCoeff(&axis) < kAlike) continue;
    ++n_along;
    n_oblique += is_oblique(frame.axes.row(axis)) ? 1U : 0U;
  }
  const auto n_sampled = static_cast<double>(faces.n_sampled);
  return static_cast<double>(n_along) >= kLeastShare * n_sampled &&
         static_cast<double>(n_oblique) >= kLeastOblique * n_sampled;
}

std::optional<BoxFrame> find_frame(const FaceTree& tree) {
  const double size = tree.bounds().diagonal().norm();
  if (tree.n_faces() < kFewestFaces || !(size > kSmallestMesh && size < kLargestMesh)) {
    return std::nullopt;
  }
  // The roundings of turned places are in proportion to the box of all faces. Where the map is that
  // of fewer, they might be larger than what slabs and gaps allow for.
  if (tree.has_far_faces()) return std::nullopt;
  const LongFaces faces = sample_of(tree);
  if (static_cast<double>(faces.directions.size()) <
      kLeastShare * static_cast<double>(faces.n_sampled)) {
    return std::nullopt;
  }
  const BoxFrame frame = frame_along(faces, tree.bounds().center());
  return fits(frame, faces) ? std::optional(frame) : std::nullopt;
}

}  // namespace

std::optional<FaceTree> turned_for_long_faces(const FaceTree& tree) {
  const std::optional<BoxFrame> frame = find_frame(tree);
  if (!frame) return std::nullopt;
  return FaceTree(tree, *frame);
}

}  // namespace meshalyzer
