#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/driver/rejection.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {

struct PassMemory;

/// The meaning of the groups of a file.
enum class Groups : std::uint8_t {
  /// Groups are names, which faces keep.
  Names,
  /// Groups are the faces of a body: their common borders keep every vertex and edge, and get no
  /// more of them.
  Faces,
};

/// The limits that a repair must keep.
struct RepairLimits {
  /// The maximum distance by which a point may move. A length.
  double max_deviation = 0.0;
  /// Indexed by vertex key, which may be beyond the end: non-zero for vertices that stay in place
  /// and are neither removed nor merged into others (others may be merged into them).
  std::vector<std::uint8_t> fixed_vertices;
  Groups groups = Groups::Names;

  [[nodiscard]] bool is_fixed(const TrackedMesh& tracked, Index vertex) const {
    const Index key = tracked.vertex_keys[vertex];
    return key < fixed_vertices.size() && fixed_vertices[key] != 0;
  }
  [[nodiscard]] bool has_fixed_corner(const TrackedMesh& tracked, Index face) const {
    const Triangle& t = tracked.soup.triangles[face];
    return std::any_of(t.begin(), t.end(), [&](Index v) { return is_fixed(tracked, v); });
  }
};

/// The size of the operations that a pass proposes.
enum class OperationSize : std::uint8_t {
  /// An operation holds all changes that belong together.
  Normal,
  /// An operation holds no more than necessary, because larger operations were rejected.
  Smallest,
};

/// The input of a pass. This holds references only.
struct PassInput {
  /// The mesh before all repairs.
  const Soup& original;
  const TrackedMesh& tracked;
  /// The data prepared from tracked.soup.
  const PreparedMesh& mesh;
  const Tolerances& tolerances;
  const RepairLimits& limits;
  OperationSize operation_size = OperationSize::Normal;
  /// Called now and then by a pass that takes long, from any thread; once it returns true, the pass
  /// ends as soon as it can, and what it proposes is not applied.
  StopQuery wants_to_stop = {};
  /// The length in use, for a pass that has some: see PassLengths.
  double length = 0.0;
  /// The number of the mesh among all that this repair has had; 0 if that is not known.
  std::size_t mesh_number = 0;
  /// What passes know of earlier meshes of this repair, all with the same options; they add to it.
  /// May be null.
  PassMemory* memory = nullptr;
};

/// A defect that a pass could not repair, and the reason.
struct Refusal {
  DefectCode code;
  /// The lowest vertex and face that name it, by index in the soup, or kNoIndex.
  Index vertex = kNoIndex;
  Index face = kNoIndex;
  /// The sentence for logs: "collapsing it would turn a neighbour over", ...
  std::string reason;
  /// The rule of acceptance that every repair would have broken; None if the reason is another.
  Rejection rejection = Rejection::None;
};

/// The proposal of a pass.
struct PassResult {
  Edits edits;
  std::vector<Refusal> refused;
  /// Tells whether the pass may propose others for OperationSize::Smallest.
  bool has_smaller_operations = false;
};

/// A pass examines a mesh and proposes changes, but makes none. Its result depends on nothing but
/// its input, of which the memory is a part, and is the same for any number of threads.
///
/// It leaves sound elements alone, and proposes nothing for a mesh without the defects that it
/// repairs. A proposal may be partial: the pass runs again after its edits were applied, until it
/// proposes nothing more, so each proposal must make progress.
using PassFunction = std::function<PassResult(const PassInput&)>;

/// The lengths over which a pass works, one after the other: it begins with 0, and goes on once it
/// has nothing more to propose for a length.
///
/// Returns the length after PassInput::length: a shorter one for which the pass may propose
/// something else since these vertices have changed (by key, ascending), or else the next longer
/// one; nothing if there is none. So all shorter lengths are done before it, and the mesh after a
/// length does not depend on whether longer ones follow.
using PassLengths =
    std::function<std::optional<double>(const PassInput&, std::span<const Index> changed)>;

}  // namespace meshalyzer
