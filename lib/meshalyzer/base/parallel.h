#pragma once

#include "meshalyzer/base/types.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace meshalyzer {

// A thread that waits for the end of one of these loops helps with that loop only. So it may hold
// what tasks from outside wait for.
//
// Nothing is started where one thread does all the work, so that small meshes do not wait for it.

/// A half-open range of indices, and the number of this chunk within the whole.
struct Chunk {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t number = 0;
};

/// The default chunk length of parallel_chunks(), long enough to hide the cost of a task.
inline constexpr std::size_t kChunkLength = 8192;

/// Returns the number of chunks that parallel_chunks() makes of `n` items.
[[nodiscard]] constexpr std::size_t n_chunks(std::size_t n, std::size_t length = kChunkLength) {
  return (n + length - 1) / length;
}

/// Calls `body` once for each chunk of [0, n), in parallel, in no particular order.
///
/// Where the chunks begin depends on `n` and `length` alone, never on the number of threads, so
/// that a result kept per chunk and combined in chunk order is the same for any number of threads.
///
/// @param body  Must not throw anything but what the caller expects: the first exception is
/// rethrown here.
void parallel_chunks(std::size_t n, std::size_t length, const std::function<void(Chunk)>& body);

inline void parallel_chunks(std::size_t n, const std::function<void(Chunk)>& body) {
  parallel_chunks(n, kChunkLength, body);
}

/// Computes one `T` per chunk in parallel and returns them in chunk order.
template <typename T, typename Body>
[[nodiscard]] std::vector<T> map_chunks(std::size_t n, Body&& body) {
  std::vector<T> results(n_chunks(n));
  parallel_chunks(n, [&](Chunk chunk) { results[chunk.number] = body(chunk); });
  return results;
}

/// Returns in order what `body(chunk, items)` appends for each chunk to its own list.
template <typename T, typename Body>
[[nodiscard]] std::vector<T> collect_chunks(std::size_t n, Body&& body) {
  std::vector<std::vector<T>> parts = map_chunks<std::vector<T>>(n, [&](Chunk chunk) {
    std::vector<T> items;
    body(chunk, items);
    return items;
  });
  if (parts.size() == 1) return std::move(parts.front());
  std::size_t size = 0;
  for (const std::vector<T>& part : parts) size += part.size();
  std::vector<T> all;
  all.reserve(size);
  for (const std::vector<T>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Returns the numbers below `n` for which the condition holds, ascending.
template <typename Condition>
[[nodiscard]] std::vector<Index> parallel_filter(std::size_t n, Condition&& condition) {
  return collect_chunks<Index>(n, [&](Chunk chunk, std::vector<Index>& found) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (condition(static_cast<Index>(i))) found.push_back(static_cast<Index>(i));
    }
  });
}

/// Runs the given functions, at the same time if that pays, and returns when all are done.
///
/// @param n_items  How many items a function handles; a single chunk of them pays no second thread.
void parallel_invoke(std::size_t n_items, const std::vector<std::function<void()>>& functions);

/// Returns the largest number of threads that may work in parallel here.
[[nodiscard]] std::size_t max_threads();

/// Limits the number of threads that work in parallel to `n` while it lives (0: the number of
/// cores). Of several that live the lowest counts.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t n);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace meshalyzer
