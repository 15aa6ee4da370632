#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/driver/internal/defect_inventory.h"

#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The faces and vertices of the input that an operation changes something of: the identities of
/// faces as 2 f, those of vertices that it moves as 2 v + 1. In ascending order.
using OperationSite = std::vector<std::uint64_t>;

/// An operation that a driver has applied.
struct AppliedOperation {
  std::string_view pass;
  DefectCodes may_create;
  OperationSite site;
  /// The corners of the faces that it affects, before and after: their identities, in ascending
  /// order.
  std::vector<Index> vertices;
};

/// What may not be done again, because a mesh has ended worse for it.
class BannedOperations {
 public:
  /// Bans the operations of a pass that change any of these elements.
  void add(std::string_view pass, const OperationSite& site);
  /// Bans a whole pass.
  void add(std::string_view pass);

  [[nodiscard]] bool contains(std::string_view pass, const OperationSite& site) const;
  [[nodiscard]] bool contains(std::string_view pass) const { return passes_.contains(pass); }
  /// Returns the number of different bans.
  [[nodiscard]] std::size_t size() const;

 private:
  std::map<std::string_view, std::set<std::uint64_t>> sites_;
  std::set<std::string_view> passes_;
};

/// Tells which of the operations round a defective element are held responsible for it.
enum class Blame : std::uint8_t {
  /// The last one, of a pass that may create such an element where there is one.
  Last,
  /// All of them.
  All,
};

/// Where a mesh has become worse, and by what.
struct WorsePlace {
  CountedDefect kind = CountedDefect::BorderEdges;
  ElementCorners corners;
};

/// Bans the operations that are responsible for what has made a mesh worse.
///
/// @param input  The soup before all operations.
/// @complexity   O(n log n) for n corners of operations, and O(#F).
void ban_responsible(const std::vector<AppliedOperation>& operations,
                     const std::vector<WorsePlace>& places, Blame blame, const Soup& input,
                     BannedOperations& banned);

}  // namespace meshalyzer
