#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace meshalyzer::test {

/// Tests of very many cases run one of this number of cases: all of them, unless the environment
/// variable MESHALYZER_TEST_ONE_OF says otherwise, as it does under sanitizers, which are some ten
/// times slower.
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
