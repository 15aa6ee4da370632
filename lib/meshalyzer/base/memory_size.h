#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace meshalyzer {

/// Reads an amount of memory as people write it: `4096`, `500M`, `1.5G`, `2GB`, `2GiB`.
///
/// The number may have a decimal fraction. A letter k, K, M, G or T may follow, a power of 1024,
/// and then B or iB; a B may also stand alone. A fraction of a byte is dropped.
///
/// @return The number of bytes, or nothing for any other text, for less than one byte and for a
///         number that overflows.
[[nodiscard]] std::optional<std::uint64_t> parse_memory_size(std::string_view text);

/// Returns the memory in bytes that this process can use: that of the machine, or less where its
/// control group (a container, a batch job) is limited to less.
[[nodiscard]] std::uint64_t physical_memory();

}  // namespace meshalyzer
