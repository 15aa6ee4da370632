#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace meshalyzer {

/// Finds a value by its name, such as an enumerator.
///
/// @param name_of  Returns the name of a value.
/// @return         The first value that has the name, or nothing.
template <typename Values, typename NameOf>
[[nodiscard]] std::optional<typename Values::value_type> find_named(const Values& values,
                                                                    std::string_view name,
                                                                    const NameOf& name_of) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const auto& value) { return name_of(value) == name; });
  if (found == values.end()) return std::nullopt;
  return *found;
}

}  // namespace meshalyzer
