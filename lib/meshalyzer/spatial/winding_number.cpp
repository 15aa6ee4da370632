#include "meshalyzer/spatial/winding_number.h"

#include "meshalyzer/spatial/closing_triangles.h"
#include "meshalyzer/spatial/far_field_tree.h"
#include "meshalyzer/spatial/ray_windings.h"
#include "meshalyzer/spatial/two_vectors.h"
#include "meshalyzer/spatial/unit_scale.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// A node is approximated as a whole beyond this many of its radii. The error falls with the cube
/// of this: it is below 0.003 of a winding number for real surfaces at 2, and 0.015 at 1.5.
constexpr double kFarFine = 2.0;
constexpr double kFarCoarse = 1.5;
/// A point at this distance of a triangle is on it if the size of the mesh is about 1. The distance
/// is at least a multiple of the spacing of the coordinates.
constexpr double kOnTriangle = 0x1p-40;
constexpr double kOnTriangleRoundings = 8.0;
/// Rays are used where the triangles are at least this many times as many as those that close them.
constexpr std::size_t kWorthRays = 2;
/// Beyond the square root of this distance all triangles count as a point.
constexpr double kTooFar = 1e60;

/// Winding numbers by the crossings of rays with the triangles and others that close them, less the
/// numbers of those others: exact but for the last, and the faster the smaller the boundary is.
class ClosedByTriangles {
 public:
  /// @param closing  The triangles that close the others.
  ClosedByTriangles(std::span<const Corners> triangles, std::span<const Corners> closing,
                    double near, double far)
      : all_(joined(triangles, closing), near), closing_(closing, near, far) {}

  /// Returns the numbers at two points; nothing where a ray gives no answer.
  [[nodiscard]] std::optional<Two> at(const Vec3& first, const Vec3& second) const {
    const auto of_all = all_.at_both(first, second);
    if (!of_all) return std::nullopt;
    return Two((*of_all)[0], (*of_all)[1]) - closing_.at({first, second});
  }

 private:
  static std::vector<Corners> joined(std::span<const Corners> first,
                                     std::span<const Corners> second) {
    std::vector<Corners> all(first.begin(), first.end());
    all.insert(all.end(), second.begin(), second.end());
    return all;
  }

  RayWindings all_;
  FarFieldTree closing_;
};

}  // namespace

/// The triangles, prepared for both ways to compute their winding numbers.
struct WindingNumbers::Prepared {
  /// @param triangles  Triangles that were scaled.
  Prepared(const UnitScale& unit_scale, std::span<const Corners> triangles,
           ExpectedQueries expected, double far)
      : scale(unit_scale),
        near(std::max(kOnTriangle, kOnTriangleRoundings * scale.rounding())),
        by_far_fields(triangles, near, far) {
    if (expected == ExpectedQueries::Few) return;
    const std::vector<Corners> closing = closing_triangles(triangles);
    if (kWorthRays * closing.size() > triangles.size()) return;
    by_rays.emplace(triangles, closing, near, far);
  }

  [[nodiscard]] Two at(const Vec3& first, const Vec3& second) const {
    if (by_rays) {
      if (const auto found = by_rays->at(first, second)) return *found;
    }
    return by_far_fields.at({first, second});
  }

  UnitScale scale;
  double near;
  FarFieldTree by_far_fields;
  std::optional<ClosedByTriangles> by_rays;
};

WindingNumbers::WindingNumbers(std::vector<Corners> triangles, ExpectedQueries expected,
                               WindingAccuracy accuracy) {
  const UnitScale scale(triangles);
  for (Corners& t : triangles) {
    for (Vec3& p : t) p = scale(p);
  }
  const double far = accuracy == WindingAccuracy::Fine ? kFarFine : kFarCoarse;
  prepared_ = std::make_unique<Prepared>(scale, triangles, expected, far);
}

WindingNumbers::WindingNumbers(WindingNumbers&&) noexcept = default;
WindingNumbers::~WindingNumbers() = default;

double WindingNumbers::at(const Vec3& point) const {
  return at_both(point, point)[0];
}

std::array<double, 2> WindingNumbers::at_both(const Vec3& first, const Vec3& second) const {
  const Vec3 a = prepared_->scale(first);
  const Vec3 b = prepared_->scale(second);
  const bool is_a_near = a.squaredNorm() < kTooFar;
  const bool is_b_near = b.squaredNorm() < kTooFar;
  if (!is_a_near && !is_b_near) return {0.0, 0.0};
  // A point that is too far gets the answer of the other one, which is dropped.
  const Two found = prepared_->at(is_a_near ? a : b, is_b_near ? b : a);
  return {is_a_near ? found[0] : 0.0, is_b_near ? found[1] : 0.0};
}

}  // namespace meshalyzer
