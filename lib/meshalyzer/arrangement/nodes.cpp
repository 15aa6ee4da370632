#include "meshalyzer/arrangement/nodes.h"

#include <algorithm>
#include <numeric>

namespace meshalyzer {

Nodes unite_points(const NamedPoints& first, const NamedPoints& second) {
  const auto n_first = static_cast<Index>(first.size());
  const auto at = [&](Index i) -> const ExactPoint& {
    return i < n_first ? first[i] : second[i - n_first];
  };
  std::vector<Index> order(first.size() + second.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return compare_lexicographically(at(a), at(b)) < 0; });
  Nodes nodes;
  nodes.of_first.resize(first.size());
  nodes.of_second.resize(second.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Index i = order[k];
    if (k == 0 || compare_lexicographically(at(order[k - 1]), at(i)) != 0) {
      nodes.points.push_back(at(i));
    }
    const auto node = static_cast<Index>(nodes.points.size() - 1);
    (i < n_first ? nodes.of_first[i] : nodes.of_second[i - n_first]) = node;
  }
  return nodes;
}

}  // namespace meshalyzer
