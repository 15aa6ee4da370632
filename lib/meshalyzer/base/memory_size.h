#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads an amount of memory as people write it: `4096`, `500M`, `1.5G`, `2GB`, `2GiB`.
///
/// Digits, also with a decimal fraction; then, or not, k, K, M, G or T, which are powers of 1024;
/// then, or not, B, or iB behind such a letter. A fraction of a byte is dropped.
///
/// @return Bytes; nothing for any other text, for less than one byte and for what does not fit.
[[nodiscard]] std::optional<std::uint64_t> parse_memory_size(std::string_view text);

/// Returns an amount of memory for people, to one decimal at most: `812 B`, `1.5 GB`. Units are
/// powers of 1024.
[[nodiscard]] std::string memory_size_text(std::uint64_t bytes);

/// Returns the memory that this process can have, in bytes: that of the machine, or less where its
/// control group (a container, a batch job) is given less.
[[nodiscard]] std::uint64_t physical_memory();

}  // namespace meshalyzer
