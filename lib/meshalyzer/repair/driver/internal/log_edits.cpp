#include "meshalyzer/repair/driver/internal/log_edits.h"

#include "meshalyzer/repair/edits/internal/skipped_operations.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Tells for each vertex key whether the tracked mesh has it.
std::vector<std::uint8_t> present_vertices(const TrackedMesh& tracked) {
  std::vector<std::uint8_t> present(tracked.n_vertex_keys(), 0);
  for (const Index key : tracked.vertex_keys) present[key] = 1;
  return present;
}

/// Collects the log entries of a list of edits, one for each operation, including skipped ones.
class Operations {
 public:
  explicit Operations(const MadeEdits& made)
      : made_(made),
        skipped_(made.skipped),
        was_(present_vertices(made.before)),
        is_(present_vertices(made.after)) {
    operations_.resize(made.edits.n_operations);
    log_faces();
    log_moves();
    log_vertices();
  }

  [[nodiscard]] std::vector<LoggedOperation> take() {
    std::vector<LoggedOperation> done;
    for (std::size_t op = 0; op < operations_.size(); ++op) {
      if (!skipped_(static_cast<Index>(op))) done.push_back(std::move(operations_[op]));
    }
    return done;
  }

 private:
  void log_faces() {
    const TrackedMesh& before = made_.before;
    for (const auto& removed : made_.edits.removed_faces) {
      operations_[removed.op].removed_faces.push_back(before.face_keys[removed.face]);
    }
    for (const auto& changed : made_.edits.changed_faces) {
      LoggedOperation& operation = operations_[changed.op];
      operation.changed_faces.push_back(before.face_keys[changed.face]);
      log_corner_moves(changed, operation);
    }
    auto next_key = static_cast<Index>(before.n_face_keys());
    for (const auto& added : made_.edits.added_faces) {
      if (!skipped_(added.op)) operations_[added.op].added_faces.push_back(next_key++);
    }
  }

  /// A corner whose vertex was dropped has moved to its new vertex.
  void log_corner_moves(const Edits::ChangedFace& changed, LoggedOperation& operation) const {
    const Triangle& old = made_.before.soup.triangles[changed.face];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index now = changed.corners[k];
      if (old[k] == kNoIndex || is_[made_.before.vertex_keys[old[k]]] != 0) continue;
      const Vec3& to = made_.edits.position_of(made_.before.soup, now);
      const double distance = (to - made_.before.soup.positions[old[k]]).stableNorm();
      operation.distance = std::max(operation.distance, distance);
    }
  }

  void log_moves() {
    for (const auto& moved : made_.edits.moved_vertices) {
      LoggedOperation& operation = operations_[moved.op];
      operation.moved_vertices.push_back(made_.before.vertex_keys[moved.vertex]);
      const double distance = (moved.to - made_.before.soup.positions[moved.vertex]).stableNorm();
      operation.distance = std::max(operation.distance, distance);
    }
  }

  /// Logs vertices that were added or removed, each for one of the operations that affect it.
  void log_vertices() {
    Index last = kNoIndex;
    for (const AffectedElement& entry : made_.affected.vertices) {
      if (entry.key == std::exchange(last, entry.key)) continue;
      const bool was_there = entry.key < was_.size() && was_[entry.key] != 0;
      if (was_there && is_[entry.key] == 0) {
        operations_[entry.operation].removed_vertices.push_back(entry.key);
      } else if (!was_there) {
        operations_[entry.operation].added_vertices.push_back(entry.key);
      }
    }
    for (const auto& removed : made_.edits.removed_vertices) {
      const Index key = made_.before.vertex_keys[removed.vertex];
      if (is_[key] == 0) operations_[removed.op].removed_vertices.push_back(key);
    }
  }

  const MadeEdits& made_;
  SkippedOperations skipped_;
  /// Indexed by vertex key: whether the vertex existed before, and exists after.
  std::vector<std::uint8_t> was_;
  std::vector<std::uint8_t> is_;
  std::vector<LoggedOperation> operations_;
};

void add_to_step(const LoggedOperation& operation, LogStep& step) {
  ++step.operations;
  step.faces_removed += operation.removed_faces.size();
  step.faces_added += operation.added_faces.size();
  step.faces_changed += operation.changed_faces.size();
  step.vertices_removed += operation.removed_vertices.size();
  step.vertices_added += operation.added_vertices.size();
  step.vertices_moved += operation.moved_vertices.size();
  step.distance = std::max(step.distance, operation.distance);
}

}  // namespace

void log_edits(const std::string& pass, DefectCode code, const MadeEdits& made, RepairLog& log) {
  if (log.steps.empty() || log.steps.back().pass != pass) {
    LogStep& step = log.steps.emplace_back();
    step.pass = pass;
    step.code = code;
  }
  const auto step = static_cast<Index>(log.steps.size() - 1);
  for (LoggedOperation& operation : Operations(made).take()) {
    operation.step = step;
    add_to_step(operation, log.steps.back());
    log.operations.push_back(std::move(operation));
  }
  log.steps.back().undone += static_cast<std::size_t>(
      std::count_if(made.skipped.begin(), made.skipped.end(), [](auto s) { return s != 0; }));
}

}  // namespace meshalyzer
