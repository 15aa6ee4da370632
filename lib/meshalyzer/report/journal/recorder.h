#pragma once

#include "meshalyzer/report/journal/known_lines.h"
#include "meshalyzer/set/run_listener.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace meshalyzer {

class Descriptor;

/// A journal in a file: each line is written completely before the next one begins.
class JournalFile {
 public:
  /// Makes the file a journal of the lines that are still valid.
  ///
  /// @throws IoError if it cannot be written; an older one then stays as it was.
  JournalFile(const std::string& path, const KnownLines& known);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// @throws IoError if it cannot be written.
  void append(std::string_view line);

 private:
  std::string path_;
  std::unique_ptr<Descriptor> descriptor_;
};

/// Writes a line for each finding of a run that is not known already.
class JournalRecorder : public RunListener {
 public:
  /// @param known   The known lines of the same subject. Both must outlive this object.
  /// @param append  Receives the lines.
  JournalRecorder(const JournalSubject& subject, const KnownLines& known,
                  std::function<void(std::string_view)> append);

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void on_findings(const ObjectFindings& findings) override;

 private:
  const JournalSubject& subject_;
  const KnownLines& known_;
  std::function<void(std::string_view)> append_;
};

}  // namespace meshalyzer
