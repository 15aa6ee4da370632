#pragma once

#include "meshalyzer/mesh/face_parts.h"
#include "meshalyzer/spatial/face_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Two parts of a mesh of which faces intersect; a < b.
struct PartContact {
  Index a = 0;
  Index b = 0;
  /// Tells whether some pair of their faces crosses (ContactKind::Crossing): then neither can
  /// enclose the other.
  bool crosses = false;
};

/// The data that find_nesting() needs about the parts. It only refers to them.
struct NestingInput {
  /// The part of each mesh face; every face is in one.
  FaceParts parts;
  /// #parts: 1 for the closed ones, which alone can enclose others.
  std::span<const std::uint8_t> is_closed;
  /// The pairs of parts that touch or cross, ascending by (a, b), each once; those where no closed
  /// part's box contains that of the other may be left out.
  std::span<const PartContact> contacts;
};

/// Tells how the parts of a mesh lie within each other.
struct Nesting {
  /// #parts: by how many closed parts each is enclosed.
  std::vector<Index> depth;
  /// #parts: the innermost closed part that encloses each; kNoIndex where none does.
  std::vector<Index> inside;
};

/// Finds which closed parts enclose which, exactly: a ray from a vertex leaves a part an odd number
/// of times when it lies inside. The ray is displaced symbolically, so it never grazes an edge or a
/// vertex.
///
/// Parts that touch without crossing are decided by all vertices that do not lie on the other part:
/// they must all be inside. The answer does not depend on numbering.
///
/// @complexity O(#parts log #F + hits) for parts that do not touch; times their vertices for those
/// that do.
[[nodiscard]] Nesting find_nesting(const FaceTree& tree, const NestingInput& input);

}  // namespace meshalyzer
