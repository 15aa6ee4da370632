#include "meshalyzer/defects/internal/sheet_cover.h"

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/geometry/face_measures.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace meshalyzer {
namespace {

using Polygon = std::vector<Vec3>;

/// The search for a cover of one face ends after this many pieces.
constexpr std::size_t kMaxPieces = 4096;
/// All searches together end after this many faces were examined, and this many for each face of
/// the mesh. A sheet on its own copy needs a few for each of its faces; in a heap of faces that lie
/// on each other, or in a mesh that one vertex far away stretches so that everything is within the
/// tolerance, each piece may need all.
constexpr std::size_t kMaxExamined = 4'000'000;
constexpr std::size_t kMaxExaminedPerFace = 256;

/// Returns the possible error of distances, because cuts are computed in floating point.
double rounding_of(const Box3& box) {
  if (box.isEmpty()) return 0.0;
  return 0x1p-46 * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

Vec3 middle(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  // Each term is divided first, so that the sum does not overflow.
  for (const Vec3& corner : polygon) sum += corner / static_cast<double>(polygon.size());
  return sum;
}

/// The two halves of a convex polygon that a plane cuts; either may be empty.
struct Halves {
  Polygon inside;
  Polygon outside;
};

/// @param heights  The height of each corner above the plane; inside is above.
Halves cut(const Polygon& polygon, const std::vector<double>& heights) {
  Halves halves;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = i + 1 < polygon.size() ? i + 1 : 0;
    const double here = heights[i];
    const double there = heights[next];
    if (here >= 0.0) halves.inside.push_back(polygon[i]);
    if (here <= 0.0) halves.outside.push_back(polygon[i]);
    if ((here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0)) {
      const double share = here / (here - there);
      const Vec3 crossing = polygon[i] * (1.0 - share) + polygon[next] * share;
      halves.inside.push_back(crossing);
      halves.outside.push_back(crossing);
    }
  }
  return halves;
}

/// Returns the heights of corners above the plane through side k of a triangle and perpendicular to
/// it; the triangle is above.
std::vector<double> heights_above_side(const Polygon& polygon, const Corners& t, std::size_t k) {
  const Vec3 along = (t[(k + 1) % 3] - t[k]).stableNormalized();
  const Vec3 inward = unit_normal(t).cross(along);
  std::vector<double> heights;
  heights.reserve(polygon.size());
  for (const Vec3& corner : polygon) heights.push_back(inward.dot(corner - t[k]));
  return heights;
}

}  // namespace

SheetCover::SheetCover(const PreparedMesh& mesh, std::span<const Index> patch_of_face,
                       double tolerance, const StopQuery& wants_to_stop)
    : mesh_(mesh.cut().mesh),
      closest_(mesh.tree()),
      patch_of_face_(patch_of_face),
      tolerance_(tolerance + rounding_of(mesh.tree().bounds())),
      excluded_(mesh_.n_faces(), 0),
      n_left_to_examine_(kMaxExamined + kMaxExaminedPerFace * mesh_.n_faces()),
      wants_to_stop_(wants_to_stop) {}

std::optional<double> SheetCover::measure(const SheetQuery& query) {
  for (const Index f : query.faces) excluded_[f] = 1;
  std::optional<double> largest = 0.0;
  for (const Index f : query.faces) {
    const bool is_to_stop = wants_to_stop_();
    const std::optional<double> distance = is_to_stop ? std::nullopt : measure_face(f, query);
    if (!distance) {
      largest.reset();
      break;
    }
    largest = std::max(*largest, *distance);
  }
  for (const Index f : query.faces) excluded_[f] = 0;
  return largest;
}

std::optional<double> SheetCover::measure_face(Index face, const SheetQuery& query) {
  const Corners corners = face_corners(mesh_, FaceHandle(static_cast<int>(face)));
  const Vec3 normal = unit_normal(corners);
  std::vector<Polygon> pieces{{corners.begin(), corners.end()}};
  double largest = 0.0;
  for (std::size_t n = 0; !pieces.empty(); ++n) {
    if (n == kMaxPieces) return std::nullopt;
    Polygon piece = std::move(pieces.back());
    pieces.pop_back();
    const std::optional<Corners> below = find_below(piece, query, normal);
    if (!below) return std::nullopt;
    for (std::size_t k = 0; k < 3 && !gap(piece, *below); ++k) {
      const std::vector<double> heights = heights_above_side(piece, *below, k);
      if (*std::min_element(heights.begin(), heights.end()) >= -tolerance_ / 2) continue;
      Halves halves = cut(piece, heights);
      if (halves.inside.empty()) return std::nullopt;
      if (const std::optional<double> left = gap(halves.outside, *below)) {
        largest = std::max(largest, *left);
      } else {
        pieces.push_back(std::move(halves.outside));
      }
      piece = std::move(halves.inside);
    }
    const std::optional<double> distance = gap(piece, *below);
    if (!distance) return std::nullopt;
    largest = std::max(largest, *distance);
  }
  return largest;
}

/// Finds a face below the centre of a piece, or nothing if there is none within the tolerance.
SheetCover::Below SheetCover::find_below(const Polygon& piece, const SheetQuery& query,
                                         const Vec3& normal) {
  const Vec3 point = middle(piece);
  if (!point.allFinite()) return std::nullopt;
  return query.faces_under ? find_below_among(*query.faces_under, point, normal)
                           : find_below_in_mesh(query, point, normal);
}

/// Returns the face that find_below_in_mesh() would find.
SheetCover::Below SheetCover::find_below_among(std::span<const Index> faces, const Vec3& point,
                                               const Vec3& normal) {
  if (faces.size() > n_left_to_examine_) return std::nullopt;
  n_left_to_examine_ -= faces.size();
  Below nearest;
  double least = tolerance_;
  for (const Index face : faces) {
    const Corners corners = face_corners(mesh_, FaceHandle(static_cast<int>(face)));
    const double distance = closest_on_triangle(corners, point).distance;
    const bool is_nearer = nearest ? distance < least : distance <= least;
    if (!is_nearer || !has_opposed_normal(face, normal)) continue;
    least = distance;
    nearest = corners;
  }
  return nearest;
}

SheetCover::Below SheetCover::find_below_in_mesh(const SheetQuery& query, const Vec3& point,
                                                 const Vec3& normal) {
  const std::function<bool(Index)> is_below = [&](Index face) {
    if (n_left_to_examine_ == 0) return false;
    --n_left_to_examine_;
    return std::binary_search(query.under.begin(), query.under.end(), patch_of_face_[face]) &&
           has_opposed_normal(face, normal);
  };
  const auto found = closest_.find({.point = point,
                                    .within = tolerance_,
                                    .excluded = excluded_,
                                    .is_wanted = &is_below,
                                    .near_enough = 0.0});
  if (!found) return std::nullopt;
  return face_corners(mesh_, FaceHandle(static_cast<int>(found->mesh_face)));
}

bool SheetCover::has_opposed_normal(Index face, const Vec3& normal) const {
  const Vec3 other = unit_normal(face_corners(mesh_, FaceHandle(static_cast<int>(face))));
  // A face of zero area has no normal, and may lie on any face that has one.
  return normal.isZero(0.0) ? !other.isZero(0.0) : normal.dot(other) < 0.0;
}

/// Returns the distance of the corner that is farthest from a face, if it is within the tolerance.
std::optional<double> SheetCover::gap(const Polygon& piece, const Corners& below) const {
  double farthest = 0.0;
  for (const Vec3& corner : piece) {
    const double distance = closest_on_triangle(below, corner).distance;
    if (!(distance <= tolerance_)) return std::nullopt;
    farthest = std::max(farthest, distance);
  }
  return farthest;
}

}  // namespace meshalyzer
