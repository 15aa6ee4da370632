#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace meshalyzer::test {

/// The tests of very many cases take one of so many: all of them, unless the environment's
/// MESHALYZER_TEST_ONE_OF says otherwise, as it does under sanitizers, where all is some ten times
/// slower.
[[nodiscard]] inline std::size_t one_of() {
  static const std::size_t number = [] {
    const char* const said = std::getenv("MESHALYZER_TEST_ONE_OF");
    return said == nullptr ? std::size_t{1} : std::max<std::size_t>(std::stoul(said), 1);
  }();
  return number;
}

/// Counts cases, and tells which are to be run.
class Effort {
 public:
  [[nodiscard]] bool runs_next() { return n_++ % one_of() == 0; }

 private:
  std::size_t n_ = 0;
};

}  // namespace meshalyzer::test
