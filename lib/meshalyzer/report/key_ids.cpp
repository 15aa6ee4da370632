#include "meshalyzer/report/key_ids.h"

namespace meshalyzer {
namespace {

using FinalIds = std::vector<std::optional<KeyIds::Final>>;

void note(Index key, const KeyIds::Final& final, FinalIds& ids) {
  if (key >= ids.size()) ids.resize(std::size_t{key} + 1);
  ids[key] = final;
}

void note_vertices(const TrackedMesh& tracked, const FinalMesh& mesh, std::size_t number,
                   FinalIds& ids) {
  for (std::size_t v = 0; v < tracked.vertex_keys.size(); ++v) {
    const Index record =
        mesh.vertex_records.empty() ? static_cast<Index>(v) : mesh.vertex_records[v];
    if (record == kNoIndex) continue;
    note(tracked.vertex_keys[v], {number, mesh.name.vertex_ids.of(record)}, ids);
  }
}

void note_faces(const TrackedMesh& tracked, const FinalMesh& mesh, std::size_t number,
                FinalIds& ids) {
  for (std::size_t f = 0; f < tracked.face_keys.size(); ++f) {
    note(tracked.face_keys[f], {number, mesh.face_id(static_cast<Index>(f))}, ids);
  }
}

std::optional<KeyIds::Final> final_of(Index key, const FinalIds& ids) {
  return key < ids.size() ? ids[key] : std::nullopt;
}

/// Returns the ids of a list of keys; those below n_input are the records of the input.
std::vector<std::int64_t> ids_of(const std::vector<Index>& keys, const Ids& input,
                                 std::size_t n_input, const FinalIds& ids) {
  std::vector<std::int64_t> list;
  for (const Index key : keys) {
    if (key < n_input) {
      list.push_back(input.of(key));
    } else if (const auto final = final_of(key, ids)) {
      list.push_back(final->id);
    }
  }
  return list;
}

}  // namespace

KeyIds::KeyIds(const RepairReport& report) : input_(report.input) {
  for (std::size_t i = 0; i < report.meshes.size(); ++i) {
    const TrackedMesh& tracked = report.result.meshes[i].tracked;
    note_vertices(tracked, report.meshes[i], i, vertices_);
    note_faces(tracked, report.meshes[i], i, faces_);
  }
}

std::vector<std::int64_t> KeyIds::vertices(const std::vector<Index>& keys) const {
  return ids_of(keys, input_.vertex_ids, input_.n_vertices, vertices_);
}

std::vector<std::int64_t> KeyIds::faces(const std::vector<Index>& keys) const {
  return ids_of(keys, input_.face_ids, input_.n_faces, faces_);
}

std::optional<KeyIds::Final> KeyIds::final_vertex(Index key) const {
  return final_of(key, vertices_);
}

std::optional<KeyIds::Final> KeyIds::final_face(Index key) const {
  return final_of(key, faces_);
}

}  // namespace meshalyzer
