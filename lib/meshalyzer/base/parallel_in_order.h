#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Decides what happens after an item has been used.
enum class Next { GoOn, Stop };

/// Does the work of parallel_in_order() for a caller that stores the items itself: `make(i)` leaves
/// item i where `use(i)` finds it. An item is in flight from the beginning of its make to the end
/// of its use. The items in flight are consecutive and never more than `at_once`, which must not be
/// 0, so that no two of them have the same i % at_once.
void run_in_order(std::size_t n, std::size_t at_once, const std::function<void(std::size_t)>& make,
                  const std::function<Next(std::size_t)>& use);

/// Makes items in parallel and uses them one at a time, in order: calls `made = make(i)` for each i
/// in [0, n), several at the same time, and `use(i, made)` for each in order of i, never two at a
/// time, from any thread.
///
/// Both may run parallel loops of their own: a thread that waits in one never begins another item.
///
/// The items used and the exception thrown do not depend on the number of threads. After `use` has
/// returned Next::Stop no further item is used; those already made, or failed, are dropped. An
/// exception of make(i) is rethrown here once the items before i have been used; an exception of
/// `use` stops like Next::Stop and is rethrown.
///
/// @param at_once  The largest number of items that are being made, wait or are in use, which
///                 bounds the memory. 0 counts as 1.
/// @param make     `T make(std::size_t i)`; T may be move-only. Must be safe to call from several
///                 threads at once.
/// @param use      `Next use(std::size_t i, T made)`.
template <typename Make, typename Use>
void parallel_in_order(std::size_t n, std::size_t at_once, Make&& make, Use&& use) {
  using Item = std::optional<std::decay_t<std::invoke_result_t<Make&, std::size_t>>>;
  const std::size_t n_places = std::max<std::size_t>(1, std::min(at_once, n));
  std::vector<Item> places(n_places);
  run_in_order(
      n, n_places, [&](std::size_t i) { places[i % n_places].emplace(make(i)); },
      [&](std::size_t i) { return use(i, *std::exchange(places[i % n_places], std::nullopt)); });
}

}  // namespace meshalyzer
