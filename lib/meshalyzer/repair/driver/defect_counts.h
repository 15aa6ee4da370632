#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace meshalyzer {

/// A kind of defective element that a repair counts before and after, the gravest first. A repair
/// leaves no more of a kind than there were: "Never worse" in doc/repair.md says what is excepted.
enum class CountedDefect : std::uint8_t {
  NonManifoldEdges,
  NonManifoldVertices,
  PinchedVertices,
  IntersectingPairs,
  FlippedEdges,
  BorderEdges,
  SlitEdges,
  DuplicateFaces,
  ZeroAreaFaces,
};

inline constexpr std::size_t kCountedDefects = 9;

/// Returns the words for reports: "border edges", ...
[[nodiscard]] std::string_view name_of(CountedDefect kind);

/// A count that is higher after a repair than it was before.
struct CountRise {
  CountedDefect kind = CountedDefect::BorderEdges;
  std::size_t before = 0;
  std::size_t after = 0;
};

}  // namespace meshalyzer
