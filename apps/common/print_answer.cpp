#include "print_answer.h"

#include <ostream>

namespace meshalyzer {

ExitCode print_answer(const std::string& answer, const std::string& program, Streams streams) {
  streams.out << answer << std::flush;
  if (streams.out) return ExitCode::Done;
  streams.err << program << ": standard output: cannot be written\n";
  return ExitCode::Failure;
}

}  // namespace meshalyzer
