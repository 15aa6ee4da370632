#include "meshalyzer/io/plain_content.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/gzip.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

bool is_text_without_newline(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    const bool is_blank = c == '\r' || c == '\t' || c == '\v' || c == '\f';
    return is_blank || static_cast<unsigned char>(c) >= ' ';
  });
}

/// Returns the part of a content that is text by its format: all but the records of binary PLY.
std::string_view text_of(std::string_view bytes) {
  constexpr std::string_view kLastLine = "\rend_header\r";
  const std::size_t last_line = bytes.find(kLastLine);
  if (!bytes.starts_with("ply\r") || last_line == std::string_view::npos) return bytes;
  const std::string_view header = bytes.substr(0, last_line + kLastLine.size());
  return header.find("\rformat binary_") == std::string_view::npos ? bytes : header;
}

/// Returns the text in which all lines end with CR alone; empty if it has others.
std::string_view text_of_returns(std::string_view bytes) {
  const std::size_t first = bytes.find_first_of("\r\n");
  if (first == std::string_view::npos || bytes.substr(first, 2) == "\r\n" || bytes[first] == '\n') {
    return {};
  }
  const std::string_view text = text_of(bytes);
  return is_text_without_newline(text) ? text : std::string_view{};
}

}  // namespace

PlainContent::PlainContent(std::string_view content, const std::string& name)
    : bytes_(content), was_gzipped_(is_gzip(content)) {
  if (was_gzipped_) {
    copy_ = unpack_gzip(content, name);
    bytes_ = copy_;
  }
  if (was_gzipped_ && is_gzip(bytes_)) {
    throw IoError(name, {.byte = 0}, "is gzipped twice");
  }
  std::size_t n = 0;
  while (bytes_.substr(n, kByteOrderMark.size()) == kByteOrderMark) {
    n += kByteOrderMark.size();
  }
  mark_ = bytes_.substr(0, n);
  bytes_.remove_prefix(n);
  replace_returns();
}

void PlainContent::replace_returns() {
  const std::size_t n_bytes = text_of_returns(bytes_).size();
  if (n_bytes == 0) return;
  if (!was_gzipped_) {
    copy_ = bytes_;
    bytes_ = copy_;
  }
  const auto begin = copy_.end() - static_cast<std::ptrdiff_t>(bytes_.size());
  std::replace(begin, begin + static_cast<std::ptrdiff_t>(n_bytes), '\r', '\n');
}

}  // namespace meshalyzer
