#pragma once

#include "exit_code.h"
#include "inputs.h"
#include "journal.h"
#include "json_output.h"
#include "meshalyzer/set/set_run.h"
#include "options.h"
#include "pictures.h"
#include "progress_line.h"
#include "streams.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// What a session works on.
struct Task {
  const Options& options;
  Inputs inputs;
  JournalSubject subject;
  /// What is known already.
  KnownLines known;
  enum class Unknown {
    /// What is not known is looked for.
    Find,
    /// All there is to know is known; what lacks is an error.
    Refuse,
  };
  Unknown unknown = Unknown::Find;
  PicturePaths pictures = {};
};

/// One call of the program: has the files analysed, and tells what is found as it is found.
class Session : public SetListener {
 public:
  Session(Task task, Streams streams);

  /// Where the lines of what is found go.
  void keep_journal(std::unique_ptr<JournalWriter> journal) { journal_ = std::move(journal); }

  [[nodiscard]] ExitCode work();

 private:
  std::optional<Analysis> known_mesh(Index number) override;
  std::optional<std::string> known_trouble(Index number) override;
  std::optional<ObjectFindings> known_findings(Index owner) override;
  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void on_findings(const ObjectFindings& findings) override;
  void on_progress(const SetProgress& progress) override;
  bool wants_to_stop() override;

  void tell(const Analysis& mesh);
  void tell_set(const SetAnalysis& set);
  void tell_interrupted();
  void complain(std::string_view message);
  [[nodiscard]] SetOptions set_options() const;
  /// Whether text goes to standard output.
  [[nodiscard]] bool tells_text() const;

  const Task task_;
  const Options& options_;
  const Inputs& inputs_;
  const JournalSubject& subject_;
  const KnownLines& known_;
  Streams streams_;
  ProgressLine progress_;
  /// Of the summary's first column.
  std::size_t name_width_;
  Pictures pictures_;
  std::optional<JsonOutput> json_;
  std::unique_ptr<JournalWriter> journal_;
  std::optional<SetProgress::Stage> last_stage_;
  std::chrono::steady_clock::time_point stage_begin_;
  std::chrono::steady_clock::time_point last_shown_;
  std::size_t n_told_ = 0;
  std::size_t n_files_done_ = 0;
  bool all_good_ = true;
  bool trouble_ = false;
  /// Standard output takes no more.
  std::atomic<bool> is_out_of_order_ = false;
};

}  // namespace meshalyzer
