#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/driver/rejection.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace meshalyzer {

/// What the groups of a file are.
enum class Groups : std::uint8_t {
  /// Names, which faces keep.
  Names,
  /// Faces of a body: their common borders keep every vertex and edge, and get no more of them.
  Faces,
};

/// Limits that a repair must keep.
struct RepairLimits {
  /// No point may move farther than this. A length.
  double max_deviation = 0.0;
  /// Indexed by vertex key, which may be beyond the end: non-zero for vertices that stay where they
  /// are and are neither removed nor merged into others (others may be merged into them).
  std::vector<std::uint8_t> fixed_vertices;
  Groups groups = Groups::Names;

  [[nodiscard]] bool is_fixed(const TrackedMesh& tracked, Index vertex) const {
    const Index key = tracked.vertex_keys[vertex];
    return key < fixed_vertices.size() && fixed_vertices[key] != 0;
  }
};

/// Tells how much a pass puts into one operation.
enum class OperationSize : std::uint8_t {
  /// All that belongs together.
  Normal,
  /// No more than is necessary, because larger operations were rejected.
  Smallest,
};

/// What a pass sees. This holds references only.
struct PassInput {
  /// The mesh before all repairs.
  const Soup& original;
  const TrackedMesh& tracked;
  /// Prepared from tracked.soup.
  const PreparedMesh& mesh;
  const Tolerances& tolerances;
  const RepairLimits& limits;
  OperationSize operation_size = OperationSize::Normal;
  /// A pass that takes long asks now and then, and proposes no more when it says yes. May be empty.
  std::function<bool()> wants_to_stop = {};
};

/// A defect that a pass could not repair, and the reason.
struct Refusal {
  DefectCode code;
  /// Elements of the soup by index: the lowest vertex or face that names it, as far as it has one.
  Index vertex = kNoIndex;
  Index face = kNoIndex;
  /// "collapsing it would turn a neighbour over", ...
  std::string reason;
  /// The rule of acceptance that no repair would have kept; None where it is something else.
  Rejection rejection = Rejection::None;
};

/// What a pass proposes.
struct PassResult {
  Edits edits;
  std::vector<Refusal> refused;
};

/// A pass looks at a mesh and proposes changes; it makes none. Pure, and the same for any number
/// of threads.
///
/// It touches nothing that is not broken, and proposes nothing for a mesh that has nothing of what
/// it treats. What it proposes need not be all: it is asked again after that was done, until it
/// proposes nothing more, so each proposal must bring the end nearer.
using PassFunction = std::function<PassResult(const PassInput&)>;

}  // namespace meshalyzer
