#pragma once

namespace meshalyzer {

/// The length of lists in a text.
enum class ListLength {
  /// The first few, and the number of the others.
  Short,
  Full,
};

}  // namespace meshalyzer
