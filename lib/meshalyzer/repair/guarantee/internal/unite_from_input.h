#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/repair/driver/internal/repair_driver.h"
#include "meshalyzer/repair/driver/options.h"
#include "meshalyzer/repair/guarantee/internal/boundary_loss.h"
#include "meshalyzer/repair/replace/internal/shell_choice.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Tells whether parts that lie inside the solid once its holes are filled may be dropped, however
/// far they are from its surface.
enum class BehindHoles : std::uint8_t { Kept, Dropped };

/// What becomes of some parts of the mesh in unite_from_input().
struct UnionChoice {
  BehindHoles behind_holes = BehindHoles::Kept;
  std::optional<ShellChoice> shells = {};
  /// If above 0, this share of the maximum deviation is the least distance by which parts are moved
  /// outward first, see offset_parts().
  double offset_share = 0.0;

  /// Tells whether parts are changed before they are united. Then only samples of what bounds the
  /// solid by winding number tell what is lost; else also all faces do that are not proved to be
  /// walls inside the solid.
  [[nodiscard]] bool changes_parts() const { return shells || offset_share > 0.0; }
};

/// A union that was not kept, to return to it after all.
struct RejectedUnion {
  RepairDriver::Checkpoint made;
  double deviation = 0.0;
  /// A sentence that says what was done.
  std::string note;
};

/// What a union of a mesh leaves for the next one, with other shells or the same offset.
struct UnionMemory {
  /// The mesh that it has replaced; unions with different shells start from the same one.
  std::shared_ptr<const ReplacedMesh> replaced;
  /// The last union without shells that was good, but too far from the input; null if there was
  /// none.
  std::shared_ptr<const RepairState> too_far;
  /// Whether it has filled the holes of sheets.
  FillSheets sheets = FillSheets::No;
  /// The same union, if it would be within the maximum deviation with BehindHoles::Dropped.
  std::optional<RejectedUnion> with_parts_dropped = {};
};

/// What a union has lost, although it bounded the solid by winding number.
struct LostBoundary {
  /// The keys of faces on which a sample is too far from the union, ascending.
  std::vector<Index> face_keys;
  /// Those of them that were faces of shells, ascending.
  std::vector<Index> shell_keys = {};
  /// Tells whether one of them is of an open component that did not become a shell.
  bool has_open = false;
  /// The samples that are too far from the union.
  std::vector<Vec3> points;
};

/// The result of unite_from_input().
struct UnitedFromInput {
  /// A sentence that says what was done; empty if nothing was.
  std::string note;
  /// Tells whether the union is good, but too far from the input.
  bool is_too_far = false;
  /// Of a union that is good, but too far from the input.
  LostBoundary lost = {};
};

/// If a mesh that means a solid is not good after a repair, starts again from the input, and
/// replaces all of it by its union with itself (self_union()). A repair part by part may fail where
/// this does not, because a part that is left as it is obstructs others.
///
/// The result is kept only if it is good as its file will hold it and within the maximum deviation.
/// The parts that were dropped, although they bounded the solid by winding number, are sampled:
/// their distance from the result counts as deviation.
///
/// @param memory  What the last call has left; empty before the first one.
[[nodiscard]] UnitedFromInput unite_from_input(RepairDriver& driver, const RepairOptions& options,
                                               const UnionChoice& choice, UnionMemory& memory);

}  // namespace meshalyzer
