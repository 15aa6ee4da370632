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
  /// The calls of it, a line each, without the word "Usage".
  std::vector<std::string> calls;
  std::string purpose;
  /// The text at the end of --help.
  std::string footer;
  /// The text that --version prints; there is no such option where it is empty.
  std::string version;
};

/// The options of a program. Each is declared once: its name, what becomes of its value, and what
/// --help says of it. Help lists them as they are declared, in groups.
class OptionTable {
 public:
  /// Puts a value where it belongs.
  /// @throws UsageError where the text says none.
  using Take = std::function<void(const std::string& text, const std::string& option)>;

  explicit OptionTable(ProgramTexts texts);
  ~OptionTable();
  OptionTable(const OptionTable&) = delete;
  OptionTable& operator=(const OptionTable&) = delete;

  /// Arguments that are no options, any number of them.
  void arguments(const std::string& name, std::vector<std::string>& target,
                 const std::string& help);
  /// Begins a group. What stands before the first is not shown.
  void group(const std::string& title) { group_ = title; }
  void flag(const std::string& name, std::function<void()> set, const std::string& help);
  void flag(const std::string& name, bool& target, const std::string& help);
  /// @param names  As help shows them: `-b N`, `-b,--shorter-than N`.
  void option(const std::string& names, Take take, const std::string& help);
  /// An option that may be given several times; each value is taken.
  void repeatable(const std::string& names, Take take, const std::string& help);
  /// An option whose value may be left out: `--json[=FILE]`. What follows it on the command line is
  /// never taken for its value.
  ///
  /// @param otherwise  The value where none is given.
  void option_or(const std::string& otherwise, const std::string& names, Take take,
                 const std::string& help);

  /// Adds -h, --help and --version, and takes the values of a command line, in the order of the
  /// declarations.
  ///
  /// @return The text that --help or --version asks for; then no value was taken.
  /// @throws UsageError  where the command line is wrong; an empty value is.
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

/// Takes what `read`, a function of text and option, makes of a value.
template <typename Target, typename Read>
OptionTable::Take into(Target& target, Read read) {
  return [&target, read = std::move(read)](const std::string& text, const std::string& option) {
    target = read(text, option);
  };
}

/// Takes the text of a value for an optional that is made of a text.
template <typename Target>
OptionTable::Take into(Target& target) {
  return [&target](const std::string& text, const std::string&) {
    target = typename Target::value_type{text};
  };
}

}  // namespace meshalyzer
