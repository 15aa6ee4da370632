#pragma once

#include <cstddef>
#include <optional>

namespace meshalyzer {

template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// Converts to any type in an unevaluated expression. Optionals are excluded: they convert from
/// their content, so there would be two ways to make one.
struct AnyValue {
  template <typename T>
  requires(!kIsOptional<T>) operator T() const;
};

/// Counts the members of an aggregate without bases: the number of values that can initialize it. A
/// static_assert with it proves that a list of all members is complete.
template <typename T, typename... Values>
consteval std::size_t member_count(Values... values) {
  if constexpr (requires { T{values..., AnyValue{}}; }) {
    return member_count<T>(values..., AnyValue{});
  } else {
    return sizeof...(values);
  }
}

}  // namespace meshalyzer
