#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace meshalyzer {
namespace {

/// The number of limits to one thread that are alive. oneTBB does not learn of these: starting it
/// takes longer than the report of a small mesh.
std::atomic<std::size_t> n_serial_limits = 0;

/// Calls `body` for each number below `n`, in parallel. Without isolation a thread that waits for
/// the last of them might take a task from outside.
template <typename Body>
void run_at_once(std::size_t n, const Body& body) {
  if (n <= 1 || max_threads() == 1) {
    for (std::size_t i = 0; i < n; ++i) body(i);
  } else {
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, n, body); });
  }
}

}  // namespace

void parallel_chunks(std::size_t n, std::size_t length, const std::function<void(Chunk)>& body) {
  run_at_once(n_chunks(n, length), [&](std::size_t number) {
    const std::size_t begin = number * length;
    body({.begin = begin, .end = std::min(begin + length, n), .number = number});
  });
}

void parallel_invoke(std::size_t n_items, const std::vector<std::function<void()>>& functions) {
  if (n_items <= kChunkLength) {
    for (const auto& function : functions) function();
  } else {
    run_at_once(functions.size(), [&](std::size_t i) { functions[i](); });
  }
}

std::size_t max_threads() {
  return n_serial_limits != 0
             ? 1
             : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

struct ThreadLimit::Control {
  explicit Control(std::size_t n) {
    if (n == 1) {
      ++n_serial_limits;
    } else {
      limit.emplace(tbb::global_control::max_allowed_parallelism, n);
    }
  }
  ~Control() {
    if (!limit) --n_serial_limits;
  }
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;

  std::optional<tbb::global_control> limit;
};

ThreadLimit::ThreadLimit(std::size_t n)
    : control_(n == 0 ? nullptr : std::make_unique<Control>(n)) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace meshalyzer
