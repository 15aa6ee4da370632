#include "terminal.h"

#include <iostream>
#include <unistd.h>

namespace meshalyzer {

bool is_terminal(const std::ostream& out) {
  if (&out == &std::cout) return ::isatty(STDOUT_FILENO) == 1;
  return &out == &std::cerr && ::isatty(STDERR_FILENO) == 1;
}

}  // namespace meshalyzer
