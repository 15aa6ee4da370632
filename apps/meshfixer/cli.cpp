#include "cli.h"

#include "exit_code.h"
#include "guarded.h"
#include "meshalyzer/base/parallel.h"
#include "options.h"
#include "print_answer.h"
#include "session.h"

#include <ostream>

namespace meshalyzer::fixer {
namespace {

ExitCode run_command(int argc, const char* const* argv, Streams streams) {
  const CommandLine command = parse_command_line(argc, argv);
  if (command.answer) return print_answer(*command.answer, "meshfixer", streams);
  const ThreadLimit limit(command.options.threads);
  return work(command.options, streams);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  const Streams streams{out, err};
  return run_guarded("meshfixer", streams, [&] { return run_command(argc, argv, streams); });
}

}  // namespace meshalyzer::fixer
