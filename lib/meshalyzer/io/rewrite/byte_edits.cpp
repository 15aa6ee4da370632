#include "meshalyzer/io/rewrite/byte_edits.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {

void ByteEdits::replace(std::size_t begin, std::size_t end, std::string text) {
  if (begin != end || !text.empty()) {
    edits_.push_back({begin, end, std::move(text)});
  }
}

void ByteEdits::replace(std::string_view part, std::string text) {
  if (part != text) {
    const std::size_t begin = offset_of(part);
    replace(begin, begin + part.size(), std::move(text));
  }
}

std::string ByteEdits::apply() {
  // An insertion before a replaced part has the same begin, and an earlier end.
  const auto comes_first = [](const Edit& a, const Edit& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
  };
  if (!std::is_sorted(edits_.begin(), edits_.end(), comes_first)) {
    std::stable_sort(edits_.begin(), edits_.end(), comes_first);
  }
  std::size_t size = source_.size();
  for (const Edit& edit : edits_) {
    size += edit.text.size();
  }
  std::string bytes;
  bytes.reserve(size);
  std::size_t copied = 0;
  for (const Edit& edit : edits_) {
    bytes += source_.substr(copied, edit.begin - copied);
    bytes += edit.text;
    copied = edit.end;
  }
  bytes += source_.substr(copied);
  edits_.clear();
  return bytes;
}

}  // namespace meshalyzer
