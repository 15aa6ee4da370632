#include "meshalyzer/spatial/order_by_size.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/box_tree.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// Sizes of one class differ by less than this power of two.
constexpr int kBinaryDigitsOfSize = 2;

/// Returns the sizes of triangles as classes, from 0 for those as large as the mesh on.
int size_class_of(const Corners& t) {
  constexpr int kSmallest = 16;
  const double size = box_of(t).sizes().maxCoeff();
  if (!(size > 0.0)) return kSmallest;
  return std::min(kSmallest, std::max(0, 1 - std::ilogb(size)) / kBinaryDigitsOfSize);
}

}  // namespace

std::vector<Index> order_by_size(std::span<const Corners> triangles) {
  std::vector<Box3> boxes(triangles.size());
  std::transform(triangles.begin(), triangles.end(), boxes.begin(), box_of);
  std::vector<Index> order = order_in_space(boxes);
  std::vector<int> size_classes(triangles.size());
  std::transform(triangles.begin(), triangles.end(), size_classes.begin(), size_class_of);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return size_classes[i] < size_classes[j]; });
  return order;
}

}  // namespace meshalyzer
