#include "cli.h"

#include "arguments.h"
#include "check/command.h"
#include "check/run_check.h"
#include "exit_code.h"
#include "files.h"
#include "freed_memory.h"
#include "guarded.h"
#include "inputs.h"
#include "interrupt.h"
#include "journal.h"
#include "meshalyzer/base/nearest_name.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/report/journal/known_lines.h"
#include "meshalyzer/report/journal/parts.h"
#include "options.h"
#include "print_answer.h"
#include "request.h"
#include "run.h"
#include "streams.h"
#include "usage_error.h"

#include <array>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>

namespace meshalyzer {
namespace {

constexpr const char* kProgram = "meshalyzer";

/// Returns the options for the report of the journals: those of this call, and the offenders that
/// the journals list.
Options options_of_report(Options options, const Request& request) {
  options.offenders = request.list_offenders ? OffenderStyle::Ids : OffenderStyle::None;
  return options;
}

/// Runs `meshalyzer merge`: makes the report of a run from the journals of its shards, the same as
/// that of the whole run.
///
/// @param how  The journals, and the options of the report.
/// @throws IoError  if a journal cannot be read or belongs to another run than the first, or if a
///                  part is missing.
ExitCode merge(const Options& how, Streams streams) {
  const JournalSubject subject = read_subject(how.paths);
  const Options options = options_of_report(how, subject.request);
  // The statistics of a set are computed again from the files, which therefore must not have
  // changed.
  if (subject.request.is_set && subject.request.between.statistics) {
    require_unchanged(subject.files);
  }
  KnownLines known(subject, KnownLines::Missing::Refuse);
  for (const std::string& journal : how.paths) {
    known.add(journal);
  }
  const ThreadLimit limit(options.threads);
  const UnpackLimit unpack_limit(options.max_unpack_ratio);
  const InterruptGuard guard;
  const Inputs inputs{subject.files.paths, subject.files.names, subject.request.is_set, {}};
  const PicturePaths no_pictures;
  check_files(options, inputs, no_pictures);
  return carry_out({options, inputs, subject.request, no_pictures, &known}, streams);
}

ExitCode report(const Options& options, Streams streams) {
  const Inputs inputs = inputs_of(options);
  const ThreadLimit limit(options.threads);
  const UnpackLimit unpack_limit(options.max_unpack_ratio);
  const InterruptGuard guard;
  const Request request = request_of(options, inputs.is_set);
  const PicturePaths pictures = picture_paths(options, inputs);
  check_files(options, inputs, pictures);
  std::optional<Journal> journal;
  if (options.ndjson) {
    journal.emplace(options, inputs, request);
  }
  Run run{options, inputs, request, pictures};
  if (journal) {
    journal->open(*options.ndjson, streams.out);
    run.earlier = &journal->known();
    run.journal = &journal->recorder();
  }
  return carry_out(run, streams);
}

std::string_view first_word(int argc, const char* const* argv) {
  return argc > 1 ? argv[1] : "";
}

bool is_command(std::string_view word) {
  return word == "check" || word == "merge";
}

/// Rejects a first word that is no file and resembles a command.
void check_first_word(std::string_view word) {
  constexpr std::array<std::string_view, 2> kCommands{"check", "merge"};
  std::error_code ignored;  // a path that cannot be examined is reported when it is read
  if (!is_command(word) && !nearest_name(word, kCommands).empty() &&
      !std::filesystem::exists(word, ignored)) {
    throw UsageError("there is no file and no command '" + std::string(word) + "'" +
                     did_you_mean(word, kCommands));
  }
}

ExitCode run_command(int argc, const char* const* argv, Streams streams) {
  const std::string_view word = first_word(argc, argv);
  check_first_word(word);
  if (word == "check") {
    const CheckCommandLine line = parse_check_command_line(argc - 1, argv + 1);
    return line.answer ? print_answer(*line.answer, kProgram, streams)
                       : run_check(line.command, streams);
  }
  const bool is_merge = word == "merge";
  const CommandLine command =
      is_merge ? parse_merge_command_line(argc - 1, argv + 1) : parse_command_line(argc, argv);
  if (command.answer) return print_answer(*command.answer, kProgram, streams);
  return is_merge ? merge(command.options, streams) : report(command.options, streams);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  const Streams streams{out, err};
  return_large_blocks(1);
  const std::string_view word = first_word(argc, argv);
  const std::string name = is_command(word) ? kProgram + (' ' + std::string(word)) : kProgram;
  return run_guarded(name, streams, [&] { return run_command(argc, argv, streams); });
}

}  // namespace meshalyzer
