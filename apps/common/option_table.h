#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace meshalyzer {

/// The texts that describe a program.
struct ProgramTexts {
  /// The calls of the program, one line each, without the word "Usage".
  std::vector<std::string> calls;
  std::string purpose;
  /// The text at the end of --help.
  std::string footer;
  /// The text that --version prints; if it is empty, there is no such option.
  std::string version;
};

/// The options of a program. Each is declared once: its name, the use of its value, and its help
/// text. Help lists them in the order of the declarations, in groups.
class OptionTable {
 public:
  /// Stores a value.
  /// @throws UsageError if the text is no valid value.
  using Take = std::function<void(const std::string& text, const std::string& option)>;

  explicit OptionTable(ProgramTexts texts);
  ~OptionTable();
  OptionTable(const OptionTable&) = delete;
  OptionTable& operator=(const OptionTable&) = delete;

  /// Declares the arguments that are no options, any number of them.
  void arguments(const std::string& name, std::vector<std::string>& target,
                 const std::string& help);
  /// Begins a group. Options before the first group are not shown.
  void group(const std::string& title) { group_ = title; }
  void flag(const std::string& name, std::function<void()> set, const std::string& help);
  void flag(const std::string& name, bool& target, const std::string& help);
  /// Declares an option.
  /// @param names  The names as help shows them: `-b N`, `-b,--shorter-than N`.
  void option(const std::string& names, Take take, const std::string& help);
  /// Declares an option that may be repeated; each value is taken.
  void repeatable(const std::string& names, Take take, const std::string& help);
  /// Declares an option whose value is optional: `--json[=FILE]`. It may be given once; the next
  /// argument is never its value.
  ///
  /// @param otherwise  The value if none is given.
  void option_or(const std::string& otherwise, const std::string& names, Take take,
                 const std::string& help);

  /// Adds -h, --help and --version, parses a command line, and takes its values in the order of the
  /// declarations.
  ///
  /// @return The text for --help or --version; in this case no value was taken.
  /// @throws UsageError  if the command line is wrong; an empty value is wrong.
  [[nodiscard]] std::optional<std::string> parse(int argc, const char* const* argv);

 private:
  struct Declared {
    CLI::Option* option;
    Take take;
  };

  void declare(CLI::Option* option, const std::string& value_name, Take take);
  void take_values() const;

  std::unique_ptr<CLI::App> app_;
  ProgramTexts texts_;
  std::string group_;
  std::vector<Declared> declared_;
};

/// Returns a function that stores the result of `read`, a function of text and option.
template <typename Target, typename Read>
OptionTable::Take into(Target& target, Read read) {
  return [&target, read = std::move(read)](const std::string& text, const std::string& option) {
    target = read(text, option);
  };
}

/// Returns a function that stores the text of a value.
template <typename Target>
OptionTable::Take into(Target& target) {
  return [&target](const std::string& text, const std::string&) {
    target = typename Target::value_type{text};
  };
}

}  // namespace meshalyzer
