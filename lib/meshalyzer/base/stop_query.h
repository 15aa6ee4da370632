#pragma once

#include <concepts>
#include <functional>
#include <utility>

namespace meshalyzer {

/// Asks whether long work is to end early. Work calls it now and then, from any thread, and ends as
/// soon as it can once the answer is true. By default there is nobody to ask, and the answer is no.
class StopQuery {
 public:
  StopQuery() = default;
  template <std::predicate Function>
  StopQuery(Function asked) : asked_(std::move(asked)) {}

  [[nodiscard]] bool operator()() const { return asked_ && asked_(); }

 private:
  std::function<bool()> asked_;
};

}  // namespace meshalyzer
