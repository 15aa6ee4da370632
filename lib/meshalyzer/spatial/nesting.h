#pragma once

#include "meshalyzer/mesh/face_parts.h"
#include "meshalyzer/spatial/face_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Two parts of a mesh some of whose faces intersect; a < b.
struct PartContact {
  Index a = 0;
  Index b = 0;
  /// Tells whether some pair of their faces crosses (ContactKind::Crossing): then neither can
  /// enclose the other.
  bool crosses = false;
};

/// The data that find_nesting() needs about the parts. It only refers to them.
struct NestingInput {
  /// The part of each mesh face; every face belongs to one.
  FaceParts parts;
  /// #parts: the box of each.
  std::span<const Box3> boxes;
  /// #parts: 1 for the closed parts; only these can enclose others.
  std::span<const std::uint8_t> is_closed;
  /// The pairs of parts that touch or cross, ascending by (a, b), each once; those where no closed
  /// part's box contains that of the other may be left out.
  std::span<const PartContact> contacts;
};

/// The nesting of the parts of a mesh.
struct Nesting {
  /// #parts: the number of closed parts that enclose each.
  std::vector<Index> depth;
  /// #parts: the innermost closed part that encloses each; kNoIndex if none does.
  std::vector<Index> inside;
};

/// Finds which closed parts enclose which, exactly: a ray from a vertex leaves a part an odd number
/// of times when it lies inside. The ray is displaced symbolically, so it never grazes an edge or a
/// vertex.
///
/// Parts that touch without crossing are decided by all vertices that do not lie on the other part:
/// they must all be inside. If all vertices lie on it, as where a box reaches through a solid from
/// one side to the other, middles of edges and faces decide, of which doubles are exactly on them.
/// The answer does not depend on numbering.
///
/// @complexity O(#parts log #F + hits) for parts that do not touch; for those that do, times the
///             number of their vertices, and of their faces if all vertices lie on the other part.
[[nodiscard]] Nesting find_nesting(const FaceTree& tree, const NestingInput& input);

}  // namespace meshalyzer
