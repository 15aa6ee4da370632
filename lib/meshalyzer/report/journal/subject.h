#pragma once

#include "meshalyzer/report/journal/line.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/set/request.h"
#include "meshalyzer/set/set_files.h"

namespace meshalyzer {

/// What a journal is of: the files of a run, and what is asked of them.
struct JournalSubject {
  SetFiles files;
  Request request;

  /// The head of a line of a file.
  [[nodiscard]] LineHead head(LineHead::Kind kind, Index number) const;
  /// Whether the lines list the offending elements.
  [[nodiscard]] JsonOffenders offenders() const;
};

}  // namespace meshalyzer
