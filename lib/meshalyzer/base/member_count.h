#pragma once

#include <cstddef>
#include <optional>

namespace meshalyzer {

template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// Stands for a value of any type in a question to the compiler. Optionals are made of what they
/// hold: else there would be two ways to make one.
struct AnyValue {
  template <typename T>
  requires(!kIsOptional<T>) operator T() const;
};

/// The number of members of an aggregate without bases: as many values as can initialize it. With
/// it a list of all members can be held to be whole.
template <typename T, typename... Values>
consteval std::size_t member_count(Values... values) {
  if constexpr (requires { T{values..., AnyValue{}}; }) {
    return member_count<T>(values..., AnyValue{});
  } else {
    return sizeof...(values);
  }
}

}  // namespace meshalyzer
