#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The default limit of the ratio between unpacked and packed size of a gzipped file: enough for
/// any text, but not for a decompression bomb.
inline constexpr std::uint64_t kDefaultUnpackRatio = 1000;

/// Sets the limit of the ratio between unpacked and packed size while it exists; only one may exist
/// at a time.
class UnpackLimit {
 public:
  explicit UnpackLimit(std::uint64_t ratio);
  ~UnpackLimit();
  UnpackLimit(const UnpackLimit&) = delete;
  UnpackLimit& operator=(const UnpackLimit&) = delete;
};

/// Tells whether the content begins as gzipped content does.
[[nodiscard]] bool is_gzip(std::string_view content);

/// Unpacks all members of gzipped content. Memory is allocated only after all of it has proved to
/// be valid and not too large.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the byte offset of the damage, or if the content exceeds the limit.
[[nodiscard]] std::string unpack_gzip(std::string_view content, const std::string& name);

/// Packs content; the result depends only on the content.
[[nodiscard]] std::string pack_gzip(std::string_view content);

}  // namespace meshalyzer
