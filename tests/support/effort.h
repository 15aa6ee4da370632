#pragma once

#include <cstddef>

namespace meshalyzer::test {

/// Sanitized builds run some ten times slower: there the tests of very many cases take one of so
/// many. All are run without sanitizers.
#ifdef MESHALYZER_SANITIZED
inline constexpr std::size_t kOneOf = 6;
#else
inline constexpr std::size_t kOneOf = 1;
#endif

/// Counts cases, and tells which are to be run.
class Effort {
 public:
  [[nodiscard]] bool runs_next() { return n_++ % kOneOf == 0; }

 private:
  std::size_t n_ = 0;
};

}  // namespace meshalyzer::test
