#pragma once

#include "inputs.h"
#include "meshalyzer/report/journal/known_lines.h"
#include "meshalyzer/report/journal/recorder.h"
#include "options.h"

#include <iosfwd>
#include <optional>

namespace meshalyzer {

/// The journal of a run (--ndjson, --resume): what earlier runs left in it, and where the lines of
/// this one go.
class Journal {
 public:
  /// Reads the lines that an earlier run left where this one is to leave its own, or in the journal
  /// to be gone on with.
  /// @throws IoError if it cannot be read, or is none.
  Journal(const Options& options, const Inputs& inputs, const Request& request);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Makes it a journal of those lines that still hold, ready for more.
  /// @param out  Where the lines go that go to standard output.
  /// @throws IoError if it cannot be written.
  void open(const ReportTarget& target, std::ostream& out);

  [[nodiscard]] const KnownLines& known() const { return known_; }
  /// Returns the listener that writes the journal; only after open().
  [[nodiscard]] RunListener& recorder() { return *recorder_; }

 private:
  JournalSubject subject_;
  KnownLines known_;
  std::optional<JournalFile> file_;
  std::optional<JournalRecorder> recorder_;
};

}  // namespace meshalyzer
