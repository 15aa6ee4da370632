#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/driver/internal/defect_inventory.h"

#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The faces and vertices of the input that an operation changes, in ascending order: a face with
/// identity f is 2 f, a vertex with identity v that moves is 2 v + 1.
using OperationSite = std::vector<std::uint64_t>;

/// An operation that a driver has applied.
struct AppliedOperation {
  std::string_view pass;
  DefectCodes may_create;
  OperationSite site;
  /// The corners of the faces that it affects, before and after, by identity; in ascending order.
  std::vector<Index> vertices;
};

/// The operations that may not be repeated, because a mesh has ended worse for them.
class BannedOperations {
 public:
  /// Bans the operations of a pass that change any of these elements.
  void add(std::string_view pass, const OperationSite& site);
  /// Bans a whole pass.
  void add(std::string_view pass);

  [[nodiscard]] bool contains(std::string_view pass, const OperationSite& site) const;
  /// Returns the number of different bans.
  [[nodiscard]] std::size_t size() const;

 private:
  std::map<std::string_view, std::set<std::uint64_t>> sites_;
  std::set<std::string_view> passes_;
};

/// The operations that are held responsible for a defective element: of those near it,
enum class Responsible : std::uint8_t {
  /// The last one of a pass that may create such an element, or else the last one.
  Last,
  /// All of them.
  All,
};

/// A defective element by which a mesh has become worse.
struct WorsePlace {
  CountedDefect kind = CountedDefect::BorderEdges;
  ElementCorners corners;
};

/// Bans the operations that are responsible for a worse mesh.
///
/// @param input  The soup before all operations.
/// @complexity   O(n log n) for n corners of operations, and O(#F).
void ban_responsible(const std::vector<AppliedOperation>& operations,
                     const std::vector<WorsePlace>& places, Responsible choice, const Soup& input,
                     BannedOperations& banned);

}  // namespace meshalyzer
