#pragma once

#include "inputs.h"
#include "meshalyzer/report/journal/known_lines.h"
#include "meshalyzer/report/journal/recorder.h"
#include "options.h"

#include <iosfwd>
#include <optional>

namespace meshalyzer {

/// The journal of a run (--ndjson, --resume): the lines of earlier runs, and the destination of
/// those of this run.
class Journal {
 public:
  /// Reads the lines that earlier runs left in the journal to resume and in the file of the
  /// journal.
  /// @throws IoError if it cannot be read, or is no journal.
  Journal(const Options& options, const Inputs& inputs, const Request& request);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Reduces the journal to the lines that are still valid, and opens it for more.
  /// @param out  Standard output, to which the lines go if there is no file.
  /// @throws IoError if it cannot be written.
  void open(const ReportTarget& target, std::ostream& out);

  [[nodiscard]] const KnownLines& known() const { return known_; }
  /// Returns the listener that writes the journal; open() must have been called.
  [[nodiscard]] RunListener& recorder() { return *recorder_; }

 private:
  JournalSubject subject_;
  KnownLines known_;
  std::optional<JournalFile> file_;
  std::optional<JournalRecorder> recorder_;
};

}  // namespace meshalyzer
