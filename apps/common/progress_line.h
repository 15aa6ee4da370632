#pragma once

#include <iosfwd>
#include <string_view>

namespace meshalyzer {

/// A line on a terminal that each message overwrites and that is removed in the end.
class ProgressLine {
 public:
  enum class State { On, Off };

  ProgressLine(std::ostream& terminal, State state) : terminal_(terminal), state_(state) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::string_view message);
  void clear();

 private:
  std::ostream& terminal_;
  State state_;
  bool shown_ = false;
};

/// Returns On if `stream` is the process's standard error and that is a terminal, else Off.
[[nodiscard]] ProgressLine::State terminal_state(const std::ostream& stream);

}  // namespace meshalyzer
