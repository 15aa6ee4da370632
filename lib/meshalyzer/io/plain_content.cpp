#include "meshalyzer/io/plain_content.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/gzip.h"

#include <cstddef>

namespace meshalyzer {

PlainContent::PlainContent(std::string_view content, const std::string& name)
    : bytes_(content), was_gzipped_(is_gzip(content)) {
  if (was_gzipped_) {
    unpacked_ = unpack_gzip(content, name);
    bytes_ = unpacked_;
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
}

}  // namespace meshalyzer
