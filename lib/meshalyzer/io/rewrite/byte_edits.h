#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {

/// A copy of some bytes in which parts are replaced; all others stay the same.
class ByteEdits {
 public:
  /// @param source  The bytes, which must outlive the object.
  explicit ByteEdits(std::string_view source) : source_(source) {}

  /// Replaces the bytes from `begin` to before `end` by `text`. Parts must not overlap and may come
  /// in any order; insertions at one place are kept in the order of the calls.
  void replace(std::size_t begin, std::size_t end, std::string text);
  /// Replaces a part of the source, unless it is already the same.
  /// @param part  A view into the source.
  void replace(std::string_view part, std::string text);
  void insert(std::size_t at, std::string text) { replace(at, at, std::move(text)); }
  void erase(std::size_t begin, std::size_t end) { replace(begin, end, {}); }

  /// Records that a part of the source is lost.
  void note_loss(AttributeKind kind, std::string_view part) {
    lost_.push_back({kind, offset_of(part)});
  }
  [[nodiscard]] const std::vector<LostRecord>& lost() const { return lost_; }

  [[nodiscard]] std::string_view source() const { return source_; }
  /// Returns the offset of a view into the source.
  [[nodiscard]] std::size_t offset_of(std::string_view part) const {
    return static_cast<std::size_t>(part.data() - source_.data());
  }

  /// Returns the copy and leaves the object empty.
  ///
  /// @complexity O(bytes + edits log edits).
  [[nodiscard]] std::string apply();

 private:
  struct Edit {
    std::size_t begin;
    std::size_t end;
    std::string text;
  };
  std::string_view source_;
  std::vector<Edit> edits_;
  std::vector<LostRecord> lost_;
};

}  // namespace meshalyzer
