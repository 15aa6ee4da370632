#include "meshalyzer/checks/finding.h"

namespace meshalyzer {

void CheckTotals::add(const FileFindings& file) {
  ++meshes;
  ++(!file.is_readable() ? unreadable : file.is_good() ? good : not_good);
  for (const FindingCount& found : file.counts) {
    (found.severity == Severity::Error ? errors : warnings) += found.count;
    fixable += found.fixable;
    is_at_least = is_at_least || found.is_at_least;
  }
}

}  // namespace meshalyzer
