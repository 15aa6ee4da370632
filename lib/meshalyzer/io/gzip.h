#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Tells how many times its size a gzipped file may take where nobody says otherwise: enough for
/// any text, not for a bomb.
inline constexpr std::uint64_t kDefaultUnpackRatio = 1000;

/// Sets how many times its size a gzipped file may take, while it lives. One at a time.
class UnpackLimit {
 public:
  explicit UnpackLimit(std::uint64_t ratio);
  ~UnpackLimit();
  UnpackLimit(const UnpackLimit&) = delete;
  UnpackLimit& operator=(const UnpackLimit&) = delete;
};

/// Tells whether the content begins as gzipped content does.
[[nodiscard]] bool is_gzip(std::string_view content);

/// Unpacks gzipped content, all members of it. Nothing is kept until all of it has proved to be
/// sound and not too large.
///
/// @param name  Stands in messages.
/// @throws IoError with the byte offset of what is damaged, or where it takes more than the limit.
[[nodiscard]] std::string unpack_gzip(std::string_view content, const std::string& name);

/// Packs content: the same bytes give the same bytes.
[[nodiscard]] std::string pack_gzip(std::string_view content);

}  // namespace meshalyzer
