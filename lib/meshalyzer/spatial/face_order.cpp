#include "meshalyzer/spatial/face_order.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/select_nth.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/long_face.h"
#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

/// Of many faces about so many are looked at to find the widest axis, which need not be exactly so.
constexpr std::size_t kSampledFaces = 128;

/// The number of faces of the runs that may be sorted by their sides.
constexpr std::size_t kMostOfBundle = 512;
/// Of such a run about so many faces are looked at, and so many of these must be long.
constexpr std::size_t kSampledOfBundle = 16;
constexpr std::size_t kLongOfSample = 4;
/// Faces whose unit normals differ no more than this along each axis are of one side.
constexpr float kWidthOfSide = 0.3F;

/// Returns the number of faces in the left half of a split.
std::size_t size_of_left(std::size_t n_faces) {
  const std::size_t leaves = n_chunks(n_faces, kTreeWidth);
  return kTreeWidth * (std::bit_ceil(leaves) / 2);
}

struct WidestAxis {
  std::size_t number;
  float width;
};

/// @param place  Returns the place of an item.
template <typename Item, typename Place>
WidestAxis widest_axis(std::span<Item> items, const Place& place) {
  std::array<float, 3> low = place(items.front());
  std::array<float, 3> high = low;
  // An odd step does not stay in one row of a grid.
  const std::size_t step = items.size() / kSampledFaces | 1U;
  for (std::size_t i = 0; i < items.size(); i += step) {
    const std::array<float, 3>& at = place(items[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  const std::array<float, 3> width{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  const auto widest = std::max_element(width.begin(), width.end());
  return {static_cast<std::size_t>(widest - width.begin()), *widest};
}

/// A face that may be sorted by its normal.
struct SidedFace : FaceMiddle {
  /// Of unit length; zero for a face without area.
  std::array<float, 3> normal;
};

/// Splits faces by their normals, and those of one side by their places.
void split_by_sides(std::span<SidedFace> faces) {
  if (faces.size() <= kTreeWidth) return;
  const std::size_t left = size_of_left(faces.size());
  const auto split_along = [&](std::size_t axis, const auto& place) {
    select_nth(faces, left, [&](const SidedFace& face) {
      return std::uint64_t{ordered_bits(place(face)[axis])} << 32 | face.face;
    });
  };
  const auto normal = [](const SidedFace& face) { return face.normal; };
  const auto middle = [](const SidedFace& face) { return face.middle; };
  const WidestAxis of_normals = widest_axis(faces, normal);
  if (of_normals.width > kWidthOfSide) {
    split_along(of_normals.number, normal);
  } else {
    split_along(widest_axis(faces, middle).number, middle);
  }
  split_by_sides(faces.first(left));
  split_by_sides(faces.subspan(left));
}

class FaceOrder {
 public:
  FaceOrder(std::span<const Triangle> triangles, std::span<const Vec3> points)
      : triangles_(triangles), points_(points) {}

  void split(std::span<FaceMiddle> faces) const {
    if (faces.size() > kMostOfBundle || !is_bundle(faces)) {
      split_by_place(faces);
    } else {
      sort_by_sides(faces);
    }
  }

 private:
  /// Splits faces that are no bundle as a whole.
  void split_by_place(std::span<FaceMiddle> faces) const {
    if (faces.size() <= kTreeWidth) return;
    const std::size_t left = size_of_left(faces.size());
    const auto middle = [](const FaceMiddle& face) { return face.middle; };
    const std::size_t axis = widest_axis(faces, middle).number;
    select_nth(faces, left, [axis](const FaceMiddle& face) {
      return std::uint64_t{ordered_bits(face.middle[axis])} << 32 | face.face;
    });
    // Only runs of the largest size are looked at: parts of what is no bundle are none.
    const auto split_part = [&](std::span<FaceMiddle> part) {
      faces.size() > kMostOfBundle ? split(part) : split_by_place(part);
    };
    if (faces.size() <= kChunkLength) {
      split_part(faces.first(left));
      split_part(faces.subspan(left));
    } else {
      parallel_invoke(faces.size(), {[&] { split_part(faces.first(left)); },
                                     [&] { split_part(faces.subspan(left)); }});
    }
  }

  [[nodiscard]] bool is_bundle(std::span<const FaceMiddle> faces) const {
    const std::size_t step = faces.size() / kSampledOfBundle | 1U;
    std::size_t n_long = 0;
    for (std::size_t i = 0; i < faces.size(); i += step) {
      n_long += static_cast<std::size_t>(is_long_face(corners_of(faces[i])));
    }
    return n_long >= kLongOfSample;
  }

  void sort_by_sides(std::span<FaceMiddle> faces) const {
    std::vector<SidedFace> sided;
    sided.reserve(faces.size());
    for (const FaceMiddle& face : faces) sided.push_back({{face}, unit_normal(corners_of(face))});
    split_by_sides(sided);
    std::transform(sided.begin(), sided.end(), faces.begin(),
                   [](const SidedFace& face) { return FaceMiddle(face); });
  }

  /// Returns zero where the normal is zero, or its length overflows.
  static std::array<float, 3> unit_normal(const Corners& face) {
    const Vec3 normal = normal_of(face);
    const double length = normal.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return {};
    // Zero has one sign only, so that it has one key.
    const Eigen::Vector3f unit = (normal / length).cast<float>().array() + 0.0F;
    return {unit[0], unit[1], unit[2]};
  }

  [[nodiscard]] Corners corners_of(const FaceMiddle& face) const {
    return meshalyzer::corners_of(points_, triangles_[face.face]);
  }

  std::span<const Triangle> triangles_;
  std::span<const Vec3> points_;
};

}  // namespace

void order_for_tree(std::span<FaceMiddle> faces, std::span<const Triangle> triangles,
                    std::span<const Vec3> points) {
  FaceOrder(triangles, points).split(faces);
}

}  // namespace meshalyzer
