#include "terminal.h"

#include <iostream>
#include <unistd.h>

namespace meshalyzer {

bool is_terminal(const std::ostream& out) {
  return &out == &std::cout && ::isatty(STDOUT_FILENO) == 1;
}

}  // namespace meshalyzer
