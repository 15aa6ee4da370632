#pragma once

#include "meshalyzer/io/attributes.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// What meshfixer makes of several solids.
enum class BooleanOperation : std::uint8_t {
  /// What is inside any of them.
  Union,
  /// What is inside all of them.
  Intersection,
  /// What is inside the first and no other one.
  Difference,
  /// Each without those before it.
  SubtractInOrder,
};

/// "union", "intersection", "difference", "subtract-in-order".
[[nodiscard]] std::string_view operation_name(BooleanOperation operation);

/// One of the solids that were combined, and how much of it is in what came out.
struct BooleanOperand {
  /// The path of its file as the user named it, or "component 2 of FILE".
  std::string name;
  std::size_t n_faces = 0;
  double volume = 0.0;
  /// Faces of it that stay as they are, but for being turned over; those of which parts stay; and
  /// those of which nothing does.
  std::size_t n_whole = 0;
  std::size_t n_cut = 0;
  std::size_t n_gone = 0;
};

/// A mesh that came out.
struct BooleanOutput {
  /// The path is empty where it was not written.
  std::string path;
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
  double volume = 0.0;
  /// An upper bound of how far vertices are from where they would be without rounding, and without
  /// parting what touches.
  double largest_move = 0.0;
  bool is_good = false;
  /// In words: why it is not good.
  std::string verdict;
};

/// A boolean operation from beginning to end, for reports.
struct BooleanReport {
  BooleanOperation operation = BooleanOperation::Union;
  std::vector<BooleanOperand> operands;
  /// Tells how many pairs of faces of the operands intersect.
  std::size_t n_pairs = 0;
  /// One, or one an operand.
  std::vector<BooleanOutput> outputs;
  /// Sentences that a person should read.
  std::vector<std::string> notes;
  /// What the inputs say and the files that were written, or would be, do not.
  std::vector<AttributeCount> lost;
};

}  // namespace meshalyzer
