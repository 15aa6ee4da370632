#include "cli.h"

#include "exit_code.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "options.h"
#include "session.h"
#include "usage_error.h"

#include <exception>
#include <new>
#include <ostream>

namespace meshalyzer::fixer {
namespace {

ExitCode run_command(int argc, const char* const* argv, Streams streams) {
  const CommandLine command = parse_command_line(argc, argv);
  if (command.answer) {
    streams.out << *command.answer << std::flush;
    return streams.out ? ExitCode::Done : ExitCode::Trouble;
  }
  const ThreadLimit limit(command.options.threads);
  return work(command.options, streams);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  try {
    return static_cast<int>(run_command(argc, argv, {out, err}));
  } catch (const UsageError& error) {
    err << "meshfixer: " << error.what() << "\nTry 'meshfixer --help'.\n";
    return static_cast<int>(ExitCode::Usage);
  } catch (const IoError& error) {
    err << error.what() << '\n';
    return static_cast<int>(ExitCode::Trouble);
  } catch (const std::bad_alloc&) {
    err << "meshfixer: not enough memory\n";
    return static_cast<int>(ExitCode::Trouble);
  } catch (const std::exception& error) {
    err << "meshfixer: " << error.what() << '\n';
    return static_cast<int>(ExitCode::Trouble);
  }
}

}  // namespace meshalyzer::fixer
