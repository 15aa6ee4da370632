#pragma once

#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/pass.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace meshalyzer {

/// Groups the steps made on a working mesh into operations that do not depend on each other: a step
/// that relies on what another has changed belongs to the same operation.
class StepJournal {
 public:
  explicit StepJournal(OperationSize size)
      : most_steps_(size == OperationSize::Smallest ? 1 : kMostSteps) {}

  /// Records a step that is about to be made.
  ///
  /// @return  False if the step would make an operation too large; then it must not be made now.
  [[nodiscard]] bool record(const WorkingMesh& mesh, const MendStep& step);

  /// Returns the edits of a soup that all steps together make.
  [[nodiscard]] Edits edits(const Soup& before, const WorkingMesh& after) const;

 private:
  /// The maximum number of steps of one operation that depend on each other.
  static constexpr std::size_t kMostSteps = 512;

  using EdgeKey = std::uint64_t;
  struct Group {
    Index parent;
    std::size_t n_steps;
  };
  [[nodiscard]] Index root(Index group) const;
  [[nodiscard]] std::optional<Index> join(const std::vector<Index>& groups);
  [[nodiscard]] std::vector<Index> written_faces(const WorkingMesh& mesh,
                                                 const MendStep& step) const;
  [[nodiscard]] std::vector<Index> groups_relied_on(const std::vector<Index>& faces,
                                                    const std::vector<EdgeKey>& edges,
                                                    const MendStep& step) const;

  std::size_t most_steps_;
  std::vector<Group> groups_;
  /// The group that has changed each face or edge, or the edges at each vertex; kMany for a vertex
  /// with several groups.
  std::unordered_map<Index, Index> face_writer_;
  std::unordered_map<EdgeKey, Index> edge_writer_;
  std::unordered_map<Index, Index> vertex_writer_;
  std::unordered_map<Index, Index> mover_;
};

}  // namespace meshalyzer
