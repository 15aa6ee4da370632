#pragma once

#include "meshalyzer/io/rewrite/rewritten_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A copy of some bytes in which parts are replaced; all others come out as they were.
class ByteEdits {
 public:
  /// @param source  Must outlive the object.
  explicit ByteEdits(std::string_view source) : source_(source) {}

  /// Puts `text` in the place of the bytes from `begin` to before `end`. Parts must not overlap;
  /// they may come in any order, but what is put at one place stands there in the order of the
  /// calls.
  void replace(std::size_t begin, std::size_t end, std::string text);
  /// Replaces a part of the source, unless it says the same already.
  /// @param part  A view into the source.
  void replace(std::string_view part, std::string text);
  void insert(std::size_t at, std::string text) { replace(at, at, std::move(text)); }
  void erase(std::size_t begin, std::size_t end) { replace(begin, end, {}); }

  /// Notes that a part of the source is dropped which should not have been.
  void note_loss(AttributeKind kind, std::string_view part) {
    lost_.push_back({kind, offset_of(part)});
  }
  [[nodiscard]] const std::vector<LostRecord>& lost() const { return lost_; }

  [[nodiscard]] std::string_view source() const { return source_; }
  /// Where a view into the source begins.
  [[nodiscard]] std::size_t offset_of(std::string_view part) const {
    return static_cast<std::size_t>(part.data() - source_.data());
  }

  /// Returns the copy. The object is empty then.
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
