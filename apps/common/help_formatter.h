#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Lays out the help of both programs in 80 columns: the calls, the purpose of the program, its
/// arguments, the options in their groups, and the footer.
class HelpFormatter : public CLI::FormatterBase {
 public:
  explicit HelpFormatter(std::vector<std::string> calls) : calls_(std::move(calls)) {}

  [[nodiscard]] std::string make_help(const CLI::App* app, std::string name,
                                      CLI::AppFormatMode mode) const override;

 private:
  std::vector<std::string> calls_;
};

}  // namespace meshalyzer
