#pragma once

#include "meshalyzer/spatial/face_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// A range of angles about an axis, which may go past a full turn. The unit is 2^-32 of a turn, so
/// that differences are right as they wrap round.
struct AngleRange {
  std::uint32_t begin = 0;
  std::uint32_t width = ~std::uint32_t{0};

  /// Whether two ranges have no angle in common. One as wide as a turn is apart from none.
  [[nodiscard]] bool is_apart_from(const AngleRange& other) const {
    return other.begin - begin > width && begin - other.begin > other.width;
  }

  /// Returns a range that holds two others: the smaller one of those that begin where one of them
  /// begins.
  [[nodiscard]] static AngleRange around(const AngleRange& a, const AngleRange& b) {
    const auto from = [](const AngleRange& first, const AngleRange& second) {
      const std::uint64_t end = std::uint64_t{second.begin - first.begin} + second.width;
      const std::uint64_t width = std::max<std::uint64_t>(first.width, end);
      constexpr std::uint32_t kTurn = ~std::uint32_t{0};
      return width < kTurn ? AngleRange{first.begin, static_cast<std::uint32_t>(width)}
                           : AngleRange{};
    };
    const AngleRange from_a = from(a, b);
    const AngleRange from_b = from(b, a);
    return from_a.width < from_b.width ? from_a : from_b;
  }
};

/// Tells faces apart that have a vertex in common, where very many do, by the angles under which
/// they are seen along an axis through it.
///
/// A corner that is less than half a turn wide so seen meets the axis in the vertex only. Two such
/// corners with no angle in common therefore share nothing but the vertex.
class CornerAngles {
 public:
  /// @param proven  Non-zero for each file vertex that need not be looked at; empty where none is
  /// known.
  /// @complexity    O(#F). Holds nothing where few faces have a vertex in common.
  CornerAngles(const FaceTree& tree, std::span<const std::uint8_t> proven);

  /// Whether there is nothing to ask for: no faces are ever told apart.
  [[nodiscard]] bool empty() const { return ranges_.empty(); }

  /// Whether two faces with one of their corners at the same vertex surely share nothing else.
  ///
  /// @param slot_a, corner_a  A face by its place in the tree, and the number of its corner.
  [[nodiscard]] bool are_apart(std::size_t slot_a, std::size_t corner_a, std::size_t slot_b,
                               std::size_t corner_b) const {
    return ranges_[slot_a][corner_a].is_apart_from(ranges_[slot_b][corner_b]);
  }

  /// Returns the range of a corner; a whole turn where nothing is known.
  [[nodiscard]] AngleRange range(std::size_t slot, std::size_t corner) const {
    return empty() ? AngleRange{} : ranges_[slot][corner];
  }

 private:
  /// #slots: by corner; a whole turn where nothing is known.
  std::vector<std::array<AngleRange, 3>> ranges_;
};

}  // namespace meshalyzer
