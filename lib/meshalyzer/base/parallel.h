#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace meshalyzer {

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

/// Runs the given functions, possibly at the same time, and returns when all are done.
void parallel_invoke(const std::vector<std::function<void()>>& functions);

/// Sorts by operator<, in parallel where it pays. The sort is not stable.
void parallel_sort(std::vector<std::uint64_t>& keys);

/// Returns the largest number of threads that may work in parallel here.
[[nodiscard]] std::size_t max_threads();

/// Limits the number of threads that work in parallel to `n` while it lives (0: the number of
/// cores).
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
