#pragma once

#include "meshalyzer/io/attributes.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The boolean operations on several solids.
enum class BooleanOperation : std::uint8_t {
  /// The result is what is inside any solid.
  Union,
  /// The result is what is inside all solids.
  Intersection,
  /// The result is what is inside the first solid and no other one.
  Difference,
  /// The results are the solids, each without those before it.
  SubtractInOrder,
};

/// Returns "union", "intersection", "difference" or "subtract-in-order".
[[nodiscard]] std::string_view operation_name(BooleanOperation operation);

/// One of the combined solids, and how much of it is in the result.
struct BooleanOperand {
  /// The path of its file as the user named it, or "component 2 of FILE".
  std::string name;
  std::size_t n_faces = 0;
  double volume = 0.0;
  /// The number of its faces that stay whole, possibly reversed.
  std::size_t n_whole = 0;
  std::size_t n_cut = 0;
  std::size_t n_gone = 0;
};

/// A resulting mesh.
struct BooleanOutput {
  /// The path, which is empty if the mesh was not written.
  std::string path;
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
  double volume = 0.0;
  /// An upper bound of the distance by which rounding, and the separation of touching parts, have
  /// moved vertices.
  double largest_move = 0.0;
  bool is_good = false;
  /// The reasons in words why it is not good.
  std::string verdict;
};

/// A boolean operation from beginning to end, for reports.
struct BooleanReport {
  BooleanOperation operation = BooleanOperation::Union;
  std::vector<BooleanOperand> operands;
  /// The number of intersecting pairs of faces of the operands.
  std::size_t n_pairs = 0;
  /// The results: one, or one for each operand.
  std::vector<BooleanOutput> outputs;
  /// Sentences that a person should read.
  std::vector<std::string> notes;
  /// The attributes of the inputs that the written files lose.
  std::vector<AttributeCount> lost;
};

}  // namespace meshalyzer
