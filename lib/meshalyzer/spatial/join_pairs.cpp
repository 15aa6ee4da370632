#include "meshalyzer/spatial/join_pairs.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace meshalyzer {

std::vector<IntersectingPair> join_pairs(std::vector<std::vector<IntersectingPair>> parts) {
  using Pairs = std::vector<IntersectingPair>;
  std::size_t n_pairs = 0;
  for (const Pairs& part : parts) {
    n_pairs += part.size();
  }
  Pairs pairs;
  pairs.reserve(n_pairs);
  for (Pairs& part : parts) {
    pairs.insert(pairs.end(), part.begin(), part.end());
    Pairs().swap(part);
  }
  std::sort(pairs.begin(), pairs.end(), [](const IntersectingPair& a, const IntersectingPair& b) {
    return std::tie(a.face_a, a.face_b) < std::tie(b.face_a, b.face_b);
  });
  return pairs;
}

}  // namespace meshalyzer
