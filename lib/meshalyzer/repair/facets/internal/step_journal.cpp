#include "meshalyzer/repair/facets/internal/step_journal.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/mesh/edge_key.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace meshalyzer {
namespace {

/// Stands for several groups.
constexpr Index kMany = kNoIndex - 1;

void append_edges(const Triangle& t, std::vector<std::uint64_t>& keys) {
  if (t[0] == kNoIndex) return;
  for (std::size_t k = 0; k < 3; ++k) keys.push_back(edge_key(t[k], t[(k + 1) % 3]));
}

/// Returns the edges with more or fewer faces after a step than before, ascending.
std::vector<std::uint64_t> changed_edges(const WorkingMesh& mesh, const MendStep& step) {
  std::vector<std::uint64_t> before;
  std::vector<std::uint64_t> after;
  for (const MendStep::NewCorners& change : step.changed) {
    append_edges(mesh.triangle(change.face), before);
    append_edges(change.corners, after);
  }
  for (const MendStep::NewFace& face : step.added) append_edges(face.corners, after);
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  std::vector<std::uint64_t> changed;
  std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                std::back_inserter(changed));
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

/// The total effect of each group, in order of its lowest face.
class EditsWriter {
 public:
  EditsWriter(const Soup& before, const WorkingMesh& after) : before_(before), after_(after) {}

  void write_face(Index face, Index group) {
    if (face >= before_.n_faces()) {
      if (!after_.has(face)) return;
      const Index op = operation(group);
      edits_.added_faces.push_back({op, named(op, face), after_.original(face)});
    } else if (!after_.has(face)) {
      edits_.removed_faces.push_back({operation(group), face});
    } else if (after_.triangle(face) != before_.triangles[face]) {
      const Index op = operation(group);
      edits_.changed_faces.push_back({op, face, named(op, face)});
    }
  }

  void write_vertex(Index vertex, Index group) {
    if (after_.is_added(vertex) || after_.faces_at(vertex).empty()) return;
    edits_.moved_vertices.push_back({operation(group), vertex, after_.position(vertex)});
  }

  [[nodiscard]] Edits take() { return std::move(edits_); }

 private:
  [[nodiscard]] Index operation(Index group) {
    const auto [place, is_new] = operations_.emplace(group, Index{0});
    if (is_new) place->second = edits_.begin_operation();
    return place->second;
  }

  /// Returns the corners of a face as edits name them, and adds those vertices that are new.
  [[nodiscard]] Triangle named(Index op, Index face) {
    Triangle t = after_.triangle(face);
    for (Index& v : t) {
      if (!after_.is_added(v)) continue;
      const auto name = static_cast<Index>(before_.n_vertices() + edits_.added_vertices.size());
      const auto [place, is_new] = names_.emplace(v, name);
      if (is_new) {
        edits_.added_vertices.push_back({op, after_.position(v), after_.copied_from(v)});
      }
      v = place->second;
    }
    return t;
  }

  const Soup& before_;
  const WorkingMesh& after_;
  std::unordered_map<Index, Index> operations_;
  /// The names in the edits of the vertices that steps have added.
  std::unordered_map<Index, Index> names_;
  Edits edits_;
};

using Writers = std::vector<std::pair<Index, Index>>;

Writers in_order(const std::unordered_map<Index, Index>& writers) {
  Writers result(writers.begin(), writers.end());
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

Index StepJournal::root(Index group) const {
  while (groups_[group].parent != group) group = groups_[group].parent;
  return group;
}

/// Merges several groups and adds one step to the result; begins a new group if there are none.
std::optional<Index> StepJournal::join(const std::vector<Index>& groups) {
  std::size_t n_steps = 1;
  for (const Index group : groups) {
    if (group == kMany) return std::nullopt;
    n_steps += groups_[group].n_steps;
  }
  if (n_steps > most_steps_) return std::nullopt;
  const auto joined = groups.empty() ? static_cast<Index>(groups_.size()) : groups.front();
  if (groups.empty()) groups_.push_back({joined, 0});
  for (const Index group : groups) groups_[group].parent = joined;
  groups_[joined].n_steps = n_steps;
  return joined;
}

std::vector<Index> StepJournal::written_faces(const WorkingMesh& mesh, const MendStep& step) const {
  std::vector<Index> faces;
  for (const MendStep::NewCorners& change : step.changed) faces.push_back(change.face);
  if (step.moved) {
    const auto moved_faces = mesh.faces_at(step.moved->vertex);
    faces.insert(faces.end(), moved_faces.begin(), moved_faces.end());
  }
  for (std::size_t i = 0; i < step.added.size(); ++i) {
    faces.push_back(static_cast<Index>(mesh.n_faces() + i));
  }
  return faces;
}

std::vector<Index> StepJournal::groups_relied_on(const std::vector<Index>& faces,
                                                 const std::vector<EdgeKey>& edges,
                                                 const MendStep& step) const {
  std::vector<Index> groups;
  const auto look_up = [&](const auto& writers, auto key) {
    const auto found = writers.find(key);
    if (found == writers.end()) return;
    groups.push_back(found->second == kMany ? kMany : root(found->second));
  };
  for (const Index f : faces) look_up(face_writer_, f);
  for (const EdgeKey edge : edges) look_up(edge_writer_, edge);
  for (const auto& [a, b] : step.read_edges) look_up(edge_writer_, edge_key(a, b));
  for (const Index v : step.read_vertices) look_up(vertex_writer_, v);
  sort_unique(groups);
  return groups;
}

bool StepJournal::record(const WorkingMesh& mesh, const MendStep& step) {
  const std::vector<Index> faces = written_faces(mesh, step);
  const std::vector<EdgeKey> edges = changed_edges(mesh, step);
  const std::optional<Index> group = join(groups_relied_on(faces, edges, step));
  if (!group) return false;
  for (const Index f : faces) face_writer_[f] = *group;
  for (const EdgeKey edge : edges) {
    edge_writer_[edge] = *group;
    for (const Index v : {static_cast<Index>(edge >> 32U), static_cast<Index>(edge)}) {
      const auto [place, is_new] = vertex_writer_.emplace(v, *group);
      if (!is_new && (place->second == kMany || root(place->second) != *group)) {
        place->second = kMany;
      }
    }
  }
  if (step.moved) mover_[step.moved->vertex] = *group;
  return true;
}

Edits StepJournal::edits(const Soup& before, const WorkingMesh& after) const {
  EditsWriter writer(before, after);
  for (const auto& [face, group] : in_order(face_writer_)) writer.write_face(face, root(group));
  for (const auto& [vertex, group] : in_order(mover_)) writer.write_vertex(vertex, root(group));
  return writer.take();
}

}  // namespace meshalyzer
