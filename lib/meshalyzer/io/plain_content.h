#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// What begins a text in UTF-8 that some programs mark as such.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The content of a mesh file as its parser takes it: unpacked where it is gzipped, and without
/// byte order marks.
class PlainContent {
 public:
  /// @param content  Must outlive this object.
  /// @param name     Stands in messages.
  /// @throws IoError where it is gzipped and damaged, too large, or gzipped twice.
  PlainContent(std::string_view content, const std::string& name);
  PlainContent(const PlainContent&) = delete;
  PlainContent& operator=(const PlainContent&) = delete;

  /// Valid as long as this object and the content.
  [[nodiscard]] std::string_view bytes() const { return bytes_; }
  [[nodiscard]] bool was_gzipped() const { return was_gzipped_; }
  /// What was left out in front of bytes().
  [[nodiscard]] std::string_view mark() const { return mark_; }

 private:
  std::string unpacked_;
  std::string_view bytes_;
  bool was_gzipped_ = false;
  std::string_view mark_;
};

}  // namespace meshalyzer
