#include "option_table.h"

#include "help_formatter.h"
#include "meshalyzer/base/nearest_name.h"
#include "usage_error.h"

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

/// Splits "-b N" and "--json[=FILE]" into name and value.
std::pair<std::string, std::string> name_and_value(const std::string& names) {
  const std::size_t end = names.find_first_of(" [");
  return {names.substr(0, end), names.substr(end)};
}

/// Returns the name of an option in messages: its letter if it has one.
std::string called(const CLI::Option& option) {
  return option.get_snames().empty() ? option.get_name() : "-" + option.get_snames().front();
}

/// Rejects the option with which a message of the parser begins: it has too few values, or too
/// many.
[[noreturn]] void refuse_number(const CLI::App& app, std::string_view message) {
  const std::string name(message.substr(0, message.find(':')));
  const CLI::Option* option = app.get_option_no_throw(name);
  if (option != nullptr && option->results().empty()) {
    throw UsageError(called(*option) + " needs a value: " + called(*option) +
                     option->get_option_text());
  }
  throw UsageError((option == nullptr ? name : called(*option)) +
                   " must be given once, with one value");
}

[[noreturn]] void refuse_empty_value(const CLI::Option& option) {
  throw UsageError(called(option) + " needs a value, not an empty text");
}

/// Rejects empty values, also `--json=`, which the parser takes for `--json`.
void refuse_empty_values(const CLI::App& app, const std::vector<std::string>& arguments) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.empty()) refuse_empty_value(*option);
    }
  }
  for (const std::string& argument : arguments) {
    if (argument == "--") return;
    if (!argument.starts_with("--") || !argument.ends_with('=')) continue;
    const CLI::Option* option = app.get_option_no_throw(argument.substr(0, argument.size() - 1));
    if (option != nullptr) refuse_empty_value(*option);
  }
}

/// Rejects `-a=5` if -a is a flag. The parser takes the letters off and leaves `-=5`.
///
/// @param rest       What the parser did not recognise.
/// @param arguments  The arguments of the program.
void refuse_value_of_flag(std::string_view rest, const std::vector<std::string>& arguments) {
  if (!rest.starts_with("-=")) return;
  const std::string_view value = rest.substr(1);
  for (const std::string& argument : arguments) {
    if (argument.starts_with('-') && argument.size() > rest.size() && argument.ends_with(value)) {
      const char letter = argument[argument.size() - value.size() - 1];
      throw UsageError(std::string("-") + letter + " takes no value: " + argument);
    }
  }
}

/// Rejects the first argument that the parser did not recognise, and suggests the option that was
/// probably meant.
[[noreturn]] void refuse_unknown(const CLI::App& app, const std::vector<std::string>& arguments) {
  const std::vector<std::string> unknown = app.remaining();
  const std::string& argument = unknown.front();
  refuse_value_of_flag(argument, arguments);
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& word : option->get_lnames()) names.push_back("--" + word);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view nearest =
      argument.size() < 3 ? std::string_view()
                          : nearest_name(argument.substr(0, argument.find('=')), known);
  throw UsageError("unknown option " + argument +
                   (nearest.empty() ? "" : "; did you mean " + std::string(nearest) + "?"));
}

}  // namespace

OptionTable::OptionTable(ProgramTexts texts)
    : app_(std::make_unique<CLI::App>()), texts_(std::move(texts)) {
  app_->set_help_flag();
  app_->description(texts_.purpose);
  app_->footer(texts_.footer);
  app_->formatter(std::make_shared<HelpFormatter>(texts_.calls));
}

OptionTable::~OptionTable() = default;

void OptionTable::declare(CLI::Option* option, const std::string& value_name, Take take) {
  option->group(group_);
  option->option_text(value_name);
  declared_.push_back({option, std::move(take)});
}

void OptionTable::arguments(const std::string& name, std::vector<std::string>& target,
                            const std::string& help) {
  app_->add_option(name, target, help);
}

void OptionTable::flag(const std::string& name, std::function<void()> set,
                       const std::string& help) {
  CLI::Option* option = app_->add_flag(name)->description(help);
  declare(option, "", [set = std::move(set)](const std::string& value, const std::string& called) {
    if (value != "true") {
      throw UsageError(called + " takes no value: " + called + '=' + value);
    }
    set();
  });
}

void OptionTable::flag(const std::string& name, bool& target, const std::string& help) {
  flag(
      name, [&target] { target = true; }, help);
}

void OptionTable::option(const std::string& names, Take take, const std::string& help) {
  const auto [name, value] = name_and_value(names);
  CLI::Option* option = app_->add_option(name)->description(help);
  declare(option, value, std::move(take));
}

void OptionTable::repeatable(const std::string& names, Take take, const std::string& help) {
  const auto [name, value] = name_and_value(names);
  CLI::Option* option = app_->add_option(name)->description(help)->multi_option_policy(
      CLI::MultiOptionPolicy::TakeAll);
  declare(option, value, std::move(take));
}

void OptionTable::option_or(const std::string& otherwise, const std::string& names, Take take,
                            const std::string& help) {
  const auto [name, value] = name_and_value(names);
  CLI::Option* option = app_->add_flag(name + "{" + otherwise + "}")->description(help);
  option->multi_option_policy(CLI::MultiOptionPolicy::Throw);
  declare(option, value, std::move(take));
}

std::optional<std::string> OptionTable::parse(int argc, const char* const* argv) {
  CLI::Option* version = nullptr;
  if (!texts_.version.empty()) {
    version = app_->add_flag("--version")->description("print the version")->group(group_);
  }
  app_->set_help_flag("-h,--help", "print this help")->group(group_);
  try {
    app_->parse(argc, argv);
    refuse_empty_values(*app_, {argv, argv + argc});
    if (version != nullptr && version->as<bool>()) {
      return texts_.version;
    }
    take_values();
  } catch (const CLI::CallForHelp&) {
    return app_->help();
  } catch (const CLI::ExtrasError&) {
    refuse_unknown(*app_, {argv, argv + argc});
  } catch (const CLI::ArgumentMismatch& error) {
    refuse_number(*app_, error.what());
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  return std::nullopt;
}

void OptionTable::take_values() const {
  for (const auto& [option, take] : declared_) {
    if (option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll) {
      for (const std::string& value : option->results()) {
        take(value, called(*option));
      }
    } else if (option->count() != 0) {
      take(option->as<std::string>(), called(*option));
    }
  }
}

}  // namespace meshalyzer
