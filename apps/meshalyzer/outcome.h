#pragma once

#include "exit_code.h"
#include "meshalyzer/set/run_listener.h"

#include <cstddef>
#include <iosfwd>
#include <string>

namespace meshalyzer {

/// Determines the exit status of a run, and reports errors as they happen.
class Outcome : public RunListener {
 public:
  explicit Outcome(std::ostream& err) : err_(err) {}

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void complain(const std::string& message);

  [[nodiscard]] std::size_t n_files_done() const { return n_files_done_; }
  [[nodiscard]] ExitCode exit_code() const;

 private:
  std::ostream& err_;
  std::size_t n_files_done_ = 0;
  bool all_good_ = true;
  bool trouble_ = false;
};

}  // namespace meshalyzer
