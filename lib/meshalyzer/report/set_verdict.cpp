#include "meshalyzer/report/set_verdict.h"

#include "meshalyzer/base/grouped_digits.h"

#include <cstddef>
#include <string_view>

namespace meshalyzer {
namespace {

/// Appends the number of faults that a search has found, unless there are none.
/// @param is_stopped  Tells whether the search was stopped, so that there are at least so many.
void append_counted(std::vector<std::string>& reasons, std::size_t n, std::string_view one,
                    std::string_view many, bool is_stopped = false) {
  if (n != 0) reasons.push_back((is_stopped ? "at least " : "") + counted(n, one, many));
}

}  // namespace

void append_reasons_within(std::size_t n_not_good, std::size_t n_unreadable,
                           std::vector<std::string>& reasons) {
  append_counted(reasons, n_not_good, "mesh is not good", "meshes are not good");
  append_counted(reasons, n_unreadable, "file cannot be read", "files cannot be read");
}

void append_reasons_between(const SetIntersections& found, std::vector<std::string>& reasons) {
  // A search that was stopped is a reason even if it has found nothing.
  const std::string pairs = counted(found.n_pairs(), "pair of faces of different meshes intersects",
                                    "pairs of faces of different meshes intersect");
  if (found.is_search_stopped) {
    reasons.push_back("at least " + pairs + ", the search ended at its time limit");
  } else if (found.n_pairs() != 0) {
    reasons.push_back(pairs);
  }
  append_counted(reasons, found.contained.size(), "mesh is inside another one",
                 "meshes are inside another one", found.is_search_stopped);
  append_counted(reasons, found.partly_contained.size(), "mesh is partly inside another one",
                 "meshes are partly inside another one", found.is_search_stopped);
}

std::optional<Goodness> set_verdict(const SetAnalysis& set) {
  if (!set.good) return std::nullopt;
  Goodness verdict;
  append_reasons_within(set.not_good.size() - set.unreadable, set.unreadable, verdict.reasons);
  if (set.intersections) append_reasons_between(*set.intersections, verdict.reasons);
  verdict.good = verdict.reasons.empty();
  return verdict;
}

}  // namespace meshalyzer
