#include "meshalyzer/arrangement/nodes.h"

#include "meshalyzer/base/parallel_sort.h"

namespace meshalyzer {
namespace {

/// A point of one of the two tables, with what most comparisons ask for: the exact points are too
/// large to be fetched for each.
struct SortedPoint {
  Vec3 rounded;
  Index number;
  bool is_rounded;
};

/// Compares points of two tables, which are numbered through.
class PointOrder {
 public:
  PointOrder(const NamedPoints& first, const NamedPoints& second)
      : first_(first), second_(second), n_first_(static_cast<Index>(first.size())) {}

  [[nodiscard]] const ExactPoint& operator[](Index i) const {
    return i < n_first_ ? first_[i] : second_[i - n_first_];
  }

  [[nodiscard]] SortedPoint sorted_point(Index i) const {
    const ExactPoint& point = (*this)[i];
    return {point.rounded, i, point.is_rounded()};
  }

  /// Returns compare_lexicographically() of the exact points.
  [[nodiscard]] Sign compare(const SortedPoint& a, const SortedPoint& b) const {
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (a.rounded[k] != b.rounded[k]) return a.rounded[k] < b.rounded[k] ? -1 : 1;
      if (!a.is_rounded || !b.is_rounded) {
        return compare_lexicographically((*this)[a.number], (*this)[b.number]);
      }
    }
    return 0;
  }

  /// Tells which comes first; of equal points that with the lower number.
  [[nodiscard]] bool operator()(const SortedPoint& a, const SortedPoint& b) const {
    const Sign sign = compare(a, b);
    return sign < 0 || (sign == 0 && a.number < b.number);
  }

 private:
  const NamedPoints& first_;
  const NamedPoints& second_;
  Index n_first_;
};

}  // namespace

Nodes unite_points(const NamedPoints& first, const NamedPoints& second) {
  const PointOrder order(first, second);
  std::vector<SortedPoint> points(first.size() + second.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = order.sorted_point(static_cast<Index>(i));
  }
  parallel_sort(points, order);
  Nodes nodes;
  nodes.of_first.resize(first.size());
  nodes.of_second.resize(second.size());
  std::vector<Index> chosen;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Index i = points[k].number;
    if (k == 0 || order.compare(points[k - 1], points[k]) != 0) chosen.push_back(i);
    const auto node = static_cast<Index>(chosen.size() - 1);
    (i < first.size() ? nodes.of_first[i] : nodes.of_second[i - first.size()]) = node;
  }
  // Exact points are large, so that room is made for no more of them than there are nodes.
  nodes.points.reserve(chosen.size());
  for (const Index i : chosen) nodes.points.push_back(order[i]);
  return nodes;
}

}  // namespace meshalyzer
