#include "meshalyzer/report/text/set_totals.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/set/set_counts.h"

#include <fmt/format.h>
#include <string>

namespace meshalyzer {
namespace {

std::string volume_text(const Measure<double>& volume) {
  if (!volume.value) {
    return undefined(volume.reason);
  }
  const std::string note = volume.reason.empty() ? "" : " (" + volume.reason + ")";
  return readable(*volume.value) + note;
}

}  // namespace

void append_set_totals(LineSink& lines, const SetAnalysis& set) {
  for (const SetCount& count : kSetCounts) {
    if (count.known == Known::Always || set.is_measured) {
      lines.count(fmt::format("total {}", count.info.label), set.*count.total,
                  count.is_at_least_of(set));
    }
  }
  if (set.is_measured) {
    lines.line("total area", set.area);
    lines.line("total volume", volume_text(set.volume));
  }
}

}  // namespace meshalyzer
