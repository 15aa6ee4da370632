#include "cli.h"

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

ExitCode run_command(int argc, const char* const* argv, Streams streams) {
  const bool is_merge = argc > 1 && std::string_view(argv[1]) == "merge";
  const CommandLine command =
      is_merge ? parse_merge_command_line(argc - 1, argv + 1) : parse_command_line(argc, argv);
  if (command.answer) {
    streams.out << *command.answer << std::flush;
    return streams.out ? ExitCode::Done : ExitCode::Trouble;
  }
  return is_merge ? merge(command.options, streams) : report(command.options, streams);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  const Streams streams{out, err};
  return run_guarded("meshalyzer", streams, [&] { return run_command(argc, argv, streams); });
}

}  // namespace meshalyzer
