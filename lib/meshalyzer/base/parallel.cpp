#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace meshalyzer {

void parallel_chunks(std::size_t n, std::size_t length, const std::function<void(Chunk)>& body) {
  const std::size_t chunks = n_chunks(n, length);
  const auto run = [&](std::size_t number) {
    const std::size_t begin = number * length;
    body({.begin = begin, .end = std::min(begin + length, n), .number = number});
  };
  if (chunks == 1) {
    run(0);
    return;
  }
  tbb::parallel_for(std::size_t{0}, chunks, run);
}

void parallel_invoke(const std::vector<std::function<void()>>& functions) {
  tbb::parallel_for(std::size_t{0}, functions.size(), [&](std::size_t i) { functions[i](); });
}

void parallel_sort(std::vector<std::uint64_t>& keys) {
  tbb::parallel_sort(keys.begin(), keys.end());
}

std::size_t max_threads() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

struct ThreadLimit::Control {
  explicit Control(std::size_t n) : limit(tbb::global_control::max_allowed_parallelism, n) {}
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(std::size_t n)
    : control_(std::make_unique<Control>(
          n != 0 ? n : static_cast<std::size_t>(std::max(1, tbb::info::default_concurrency())))) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace meshalyzer
