#pragma once

#include "usage_error.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

// What the command lines of both programs have in common. Numbers are read by our own parsers, so
// that no locale reads them; an empty text stands for an option that is absent.

/// The text without the sign that the parser leaves in the value of `-g=...`.
[[nodiscard]] std::string_view without_sign(std::string_view text);

/// Parses a command line, and refuses options with an empty value.
///
/// @throws UsageError      where it is wrong.
/// @throws CLI::CallForHelp  where it asks for help.
void parse_arguments(CLI::App& app, int argc, const char* const* argv);

/// @throws UsageError if the text is no number.
[[nodiscard]] double to_real(const std::string& text, const std::string& option);

/// @throws UsageError if the text is no finite length, 0 or more.
[[nodiscard]] double to_length(const std::string& text, const std::string& option);

/// The argument of --threads; 0 where absent.
///
/// @throws UsageError if it is none.
[[nodiscard]] std::size_t to_thread_count(const std::string& text);

}  // namespace meshalyzer
