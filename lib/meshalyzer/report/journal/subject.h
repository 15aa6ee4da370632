#pragma once

#include "meshalyzer/report/journal/line.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/set/request.h"
#include "meshalyzer/set/set_files.h"

namespace meshalyzer {

/// The subject of a journal: the files of a run, and the request.
struct JournalSubject {
  SetFiles files;
  Request request;

  /// Returns the head of a line of a file.
  [[nodiscard]] LineHead head(LineHead::Kind kind, Index number) const;
  /// Tells whether the lines list the offending elements.
  [[nodiscard]] JsonOffenders offenders() const;
};

}  // namespace meshalyzer
