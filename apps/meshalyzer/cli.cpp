#include "cli.h"

#include "check/command.h"
#include "check/run_check.h"
#include "guarded.h"
#include "inputs.h"
#include "interrupt.h"
#include "journal.h"
#include "merge.h"
#include "meshalyzer/base/parallel.h"
#include "options.h"
#include "request.h"
#include "run.h"

#include <optional>
#include <ostream>
#include <string_view>

namespace meshalyzer {
namespace {

ExitCode report(const Options& options, Streams streams) {
  const Inputs inputs = inputs_of(options);
  const ThreadLimit limit(options.threads);
  const InterruptGuard guard;
  const Request request = request_of(options, inputs.is_set);
  std::optional<Journal> journal;
  if (options.ndjson) {
    journal.emplace(options, inputs, request);
  }
  const PicturePaths pictures = picture_paths(options, inputs);
  Run run{options, inputs, request, pictures};
  if (journal) {
    journal->open(*options.ndjson, streams.out);
    run.earlier = &journal->known();
    run.journal = &journal->recorder();
  }
  return carry_out(run, streams);
}

ExitCode print_answer(const std::string& answer, Streams streams) {
  streams.out << answer << std::flush;
  return streams.out ? ExitCode::Done : ExitCode::Trouble;
}

ExitCode run_command(int argc, const char* const* argv, Streams streams) {
  const std::string_view word = argc > 1 ? argv[1] : "";
  if (word == "check") {
    const CheckCommandLine line = parse_check_command_line(argc - 1, argv + 1);
    return line.answer ? print_answer(*line.answer, streams) : run_check(line.command, streams);
  }
  const bool is_merge = word == "merge";
  const CommandLine command =
      is_merge ? parse_merge_command_line(argc - 1, argv + 1) : parse_command_line(argc, argv);
  if (command.answer) return print_answer(*command.answer, streams);
  return is_merge ? merge(command.options, streams) : report(command.options, streams);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  const Streams streams{out, err};
  return run_guarded("meshalyzer", streams, [&] { return run_command(argc, argv, streams); });
}

}  // namespace meshalyzer
