#pragma once

#include "meshalyzer/report/journal/recorder.h"
#include "sample_analysis.h"
#include "support/temporary_folder.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace meshalyzer::test {

/// Three files, what is asked of them, and the journal of a run that found the first two to be
/// meshes, the third unreadable, and nothing between them.
class SmallJournal {
 public:
  SmallJournal() {
    for (const std::string& path : paths_) {
      write_bytes(path, "something");
    }
  }

  [[nodiscard]] const std::string& path(std::size_t number) const { return paths_[number]; }
  [[nodiscard]] std::string file() const { return folder_.file("journal.ndjson"); }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
  /// Returns the subject of the files as they are now.
  [[nodiscard]] JournalSubject subject(const Request& request = {}) const {
    return {stamped(paths_), request};
  }

  /// Tells a listener what the run finds.
  static void run(const JournalSubject& subject, RunListener& listener) {
    for (Index number = 0; number < 2; ++number) {
      Analysis mesh = sample_analysis();
      mesh.path = subject.files.paths[number];
      listener.on_mesh(number, mesh);
    }
    listener.on_unreadable(2, subject.files.paths[2] + ": torn");
    for (Index owner = 0; owner < 2; ++owner) {
      listener.on_findings({owner, SetIntersections{}, std::nullopt});
    }
  }

  /// The lines of the run.
  [[nodiscard]] static std::vector<std::string> lines(const JournalSubject& subject) {
    std::vector<std::string> lines;
    const KnownLines nothing(subject);
    JournalRecorder recorder(subject, nothing,
                             [&](std::string_view line) { lines.emplace_back(line); });
    run(subject, recorder);
    return lines;
  }

  /// Writes them down.
  void write(const std::string& name, const std::vector<std::string>& lines) const {
    std::string text;
    for (const std::string& line : lines) {
      text += line;
    }
    write_bytes(folder_.file(name), text);
  }
  void write(const JournalSubject& subject) const { write("journal.ndjson", lines(subject)); }

 private:
  TemporaryFolder folder_;
  std::vector<std::string> paths_{folder_.file("a.mesh"), folder_.file("b.mesh"),
                                  folder_.file("c.mesh")};
};

}  // namespace meshalyzer::test
