#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// The mark with which some programs begin a text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The content of a mesh file for its parser: unpacked if it is gzipped, without byte order mark,
/// and with lines that end with LF or CRLF.
///
/// A text in which all lines end with CR alone, as those of old Macintosh programs, gets LF in its
/// place; so does the header of a binary PLY file, which Rhinoceros writes so.
class PlainContent {
 public:
  /// @param content  The content, which must outlive this object.
  /// @param name     The name of the file in messages.
  /// @throws IoError if it is gzipped and damaged, too large, or gzipped twice.
  PlainContent(std::string_view content, const std::string& name);
  PlainContent(const PlainContent&) = delete;
  PlainContent& operator=(const PlainContent&) = delete;

  /// Returns the bytes, valid as long as this object and the content.
  [[nodiscard]] std::string_view bytes() const { return bytes_; }
  [[nodiscard]] bool was_gzipped() const { return was_gzipped_; }
  /// Returns the byte order mark that was removed in front of bytes().
  [[nodiscard]] std::string_view mark() const { return mark_; }

 private:
  void replace_returns();

  /// What bytes() shows if it is not the content as it is.
  std::string copy_;
  std::string_view bytes_;
  bool was_gzipped_ = false;
  std::string_view mark_;
};

}  // namespace meshalyzer
