#include "meshalyzer/analysis/internal/by_component.h"

#include <numeric>

namespace meshalyzer {

std::vector<Summary> summarize_by_component(std::size_t n, std::span<const double> values,
                                            const std::function<Index(std::size_t)>& component_of) {
  std::vector<std::size_t> begin(n + 1, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const Index c = component_of(i); c != kNoIndex) {
      ++begin[c + 1];
    }
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<double> grouped(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const Index c = component_of(i); c != kNoIndex) {
      grouped[next[c]++] = values[i];
    }
  }
  std::vector<Summary> summaries(n);
  for (std::size_t c = 0; c < n; ++c) {
    summaries[c] = summarize(std::span(grouped).subspan(begin[c], begin[c + 1] - begin[c]));
  }
  return summaries;
}

}  // namespace meshalyzer
