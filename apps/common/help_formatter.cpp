#include "help_formatter.h"

#include <cstddef>
#include <sstream>

namespace meshalyzer {
namespace {

constexpr std::size_t kColumns = 79;
/// The column where the description of an option begins.
constexpr std::size_t kIndent = 21;

/// Breaks a text into lines between its words; line feeds in it stay.
/// @param column  The column at which the first line begins.
/// @param indent  The column at which the other lines begin.
std::string wrapped(const std::string& text, std::size_t column, std::size_t indent) {
  std::string lines;
  std::istringstream paragraphs(text);
  std::string paragraph;
  while (std::getline(paragraphs, paragraph)) {
    if (!lines.empty()) {
      lines += '\n' + std::string(indent, ' ');
      column = indent;
    }
    std::istringstream words(paragraph);
    bool is_first = true;
    for (std::string word; words >> word; is_first = false) {
      if (!is_first && column + 1 + word.size() > kColumns) {
        lines += '\n' + std::string(indent, ' ');
        column = indent;
      } else if (!is_first) {
        lines += ' ';
        ++column;
      }
      lines += word;
      column += word.size();
    }
  }
  return lines + '\n';
}

/// Returns the names of an option and its value: "-h, --help", "-b N", "--json[=FILE]".
std::string name_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& letter : option.get_snames()) {
    names += (names.empty() ? "-" : ", -") + letter;
  }
  for (const std::string& word : option.get_lnames()) {
    names += (names.empty() ? "--" : ", --") + word;
  }
  return names + option.get_option_text();
}

std::string line_of(const CLI::Option& option) {
  std::string line = "  " + name_of(option);
  if (line.size() + 1 >= kIndent) {
    line += '\n';
    line.append(kIndent, ' ');
  } else {
    line.append(kIndent - line.size(), ' ');
  }
  return line + wrapped(option.get_description(), kIndent, kIndent);
}

}  // namespace

std::string HelpFormatter::make_help(const CLI::App* app, std::string /*name*/,
                                     CLI::AppFormatMode /*mode*/) const {
  std::string help;
  for (const std::string& call : calls_) {
    help += (help.empty() ? "Usage: " : "       ") + call + '\n';
  }
  help += wrapped(app->get_description(), 0, 0);
  for (const CLI::Option* argument :
       app->get_options([](const CLI::Option* option) { return option->get_positional(); })) {
    if (const std::string& text = argument->get_description(); !text.empty()) {
      help += '\n' + wrapped(argument->get_name(true) + " is " + text, 0, 0);
    }
  }
  for (const std::string& group : app->get_groups()) {
    const std::vector<const CLI::Option*> options =
        app->get_options([&](const CLI::Option* option) {
          return option->get_group() == group && option->nonpositional();
        });
    if (!group.empty() && !options.empty()) {
      help += '\n' + group + '\n';
      for (const CLI::Option* option : options) {
        help += line_of(*option);
      }
    }
  }
  return help + '\n' + wrapped(app->get_footer(), 0, 0);
}

}  // namespace meshalyzer
