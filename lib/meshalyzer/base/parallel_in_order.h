#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Tells what happens after an item has been used.
enum class Next { GoOn, Stop };

/// parallel_in_order() for a caller that keeps what is made itself: `make(i)` leaves item i where
/// `use(i)` finds it. An item is on its way from the beginning of its make to the end of its use:
/// these are never more than `at_once`, which must not be 0, and always consecutive, so that i %
/// at_once is a place that no other item needs.
void run_in_order(std::size_t n, std::size_t at_once, const std::function<void(std::size_t)>& make,
                  const std::function<Next(std::size_t)>& use);

/// Makes items in parallel and uses them one at a time, in order: calls `made = make(i)` for each i
/// in [0, n), several at the same time, and `use(i, made)` for each in order of i, never two at a
/// time, from any thread.
///
/// Both may run parallel loops of their own: a thread that waits in one never begins another item.
///
/// What is used, and what is thrown, do not depend on the number of threads. Once `use` has
/// returned Next::Stop nothing more is used; items beyond may have been made, or have failed to be,
/// and are dropped. An exception of make(i) is rethrown here when the items before i have been
/// used; one of `use` stops as Next::Stop does and is rethrown.
///
/// @param at_once  So many items, at most, are being made, wait for their turn or are in use: the
///                 bound of memory. 0 counts as 1.
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
