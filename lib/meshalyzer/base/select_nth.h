#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace meshalyzer {

// Selection as std::nth_element() does it, in half the time: nothing here branches on how two keys
// compare, which a processor cannot foresee.

/// Returns a key that is ordered as the numbers are; -0.0 comes before 0.0. NaN has no place.
[[nodiscard]] inline std::uint32_t ordered_bits(float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  // Negative numbers have all bits flipped, the others only the sign.
  return bits ^ ((0U - (bits >> 31)) | std::uint32_t{1} << 31);
}

[[nodiscard]] inline std::uint64_t ordered_bits(double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  return bits ^ ((std::uint64_t{0} - (bits >> 63)) | std::uint64_t{1} << 63);
}

namespace detail {

/// So few items are sorted.
inline constexpr std::size_t kFewItems = 16;

/// Puts each of a few items where it belongs, which is the number of those that come before it.
template <typename Item, typename Key>
void sort_few(std::span<Item> items, const Key& key) {
  std::array<Item, kFewItems> copies;
  std::array<std::uint64_t, kFewItems> keys;
  std::array<std::size_t, kFewItems> places;
  for (std::size_t i = 0; i < items.size(); ++i) {
    copies[i] = items[i];
    keys[i] = key(items[i]);
    places[i] = i;
    for (std::size_t j = 0; j < i; ++j) {
      const auto is_less = static_cast<std::size_t>(keys[i] < keys[j]);
      places[i] -= is_less;
      places[j] += is_less;
    }
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[places[i]] = copies[i];
  }
}

/// Moves those items to the front that `goes_first` says.
///
/// @return  How many they are.
template <typename Item, typename Predicate>
std::size_t move_to_front(std::span<Item> items, const Predicate& goes_first) {
  std::size_t n_first = 0;
  for (Item& place : items) {
    const Item item = place;
    place = items[n_first];
    items[n_first] = item;
    n_first += static_cast<std::size_t>(goes_first(item));
  }
  return n_first;
}

/// How many items of a range are looked at to find a pivot, and by how many of them the pivot is
/// taken to be on the far side of the one that is sought, so that this most likely falls into the
/// smaller part.
struct Sample {
  std::size_t size;
  std::size_t margin;
};

inline Sample sample_of(std::size_t n_items) {
  if (n_items < 128) return {5, 0};
  if (n_items < 1024) return {11, 1};
  return n_items < 16384 ? Sample{31, 2} : Sample{101, 4};
}

/// Returns the key of a pivot near the nth item.
template <typename Item, typename Key>
std::uint64_t choose_pivot(std::span<const Item> items, std::size_t nth, const Key& key) {
  const auto [size, margin] = sample_of(items.size());
  std::array<std::uint64_t, 101> keys;
  for (std::size_t i = 0; i < size; ++i) {
    keys[i] = key(items[i * (items.size() / size)]);
  }
  const std::size_t nearest = nth * size / items.size();
  const std::size_t wanted = 2 * nth < items.size() ? std::min(nearest + margin, size - 1)
                                                    : nearest - std::min(nearest, margin);
  const auto found = keys.begin() + static_cast<std::ptrdiff_t>(wanted);
  std::nth_element(keys.begin(), found, keys.begin() + static_cast<std::ptrdiff_t>(size));
  return *found;
}

}  // namespace detail

/// Puts that item at `nth` which would be there if all were sorted by key, none with a larger key
/// before it and none with a smaller one after it. In which order these are depends on the items
/// alone.
///
/// @param key   Returns a std::uint64_t for an item; items may have equal keys.
/// @param nth   Less than the number of items.
/// @complexity  O(n), at worst O(n log n).
template <typename Item, typename Key>
void select_nth(std::span<Item> items, std::size_t nth, const Key& key) {
  // After so many rounds the pivots must be bad ones.
  for (auto rounds = 2 * std::bit_width(items.size()); items.size() > detail::kFewItems; --rounds) {
    if (rounds == 0) {
      std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(nth), items.end(),
                       [&](const Item& a, const Item& b) { return key(a) < key(b); });
      return;
    }
    const std::uint64_t pivot = detail::choose_pivot<Item>(items, nth, key);
    const std::size_t less =
        detail::move_to_front(items, [&](const Item& item) { return key(item) < pivot; });
    if (nth < less) {
      items = items.first(less);
      continue;
    }
    items = items.subspan(less);
    nth -= less;
    // Hardly any were less: perhaps because many are equal.
    if (less < items.size() / 4) {
      const std::size_t equal =
          detail::move_to_front(items, [&](const Item& item) { return key(item) == pivot; });
      if (nth < equal) return;
      items = items.subspan(equal);
      nth -= equal;
    }
  }
  detail::sort_few(items, key);
}

}  // namespace meshalyzer
