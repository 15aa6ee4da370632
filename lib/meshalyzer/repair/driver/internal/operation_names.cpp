#include "meshalyzer/repair/driver/internal/operation_names.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/driver/internal/defect_inventory.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace meshalyzer {

std::vector<OperationSite> sites_of(const TrackedMesh& tracked, const Edits& edits) {
  std::vector<OperationSite> sites(edits.n_operations);
  const auto add_face = [&](Index op, Index face) {
    sites[op].push_back(2 * std::uint64_t{face_identity(tracked, tracked.face_keys[face])});
  };
  for (const auto& edit : edits.removed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.changed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.added_faces) add_face(edit.op, edit.prototype);
  for (const auto& edit : edits.moved_vertices) {
    const Index key = tracked.vertex_keys[edit.vertex];
    sites[edit.op].push_back(2 * std::uint64_t{vertex_identity(tracked, key)} + 1);
  }
  for (OperationSite& site : sites) sort_unique(site);
  return sites;
}

std::vector<OperationSignature> signatures_of(const TrackedMesh& tracked, const Edits& edits) {
  std::vector<OperationSignature> signatures(edits.n_operations);
  const auto add_face = [&](Index op, Index face) {
    signatures[op].push_back(tracked.face_keys[face]);
  };
  for (const auto& edit : edits.removed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.changed_faces) add_face(edit.op, edit.face);
  for (const auto& edit : edits.added_faces) add_face(edit.op, edit.prototype);
  for (const auto& edit : edits.moved_vertices) {
    // A prefix distinguishes keys of vertices from those of faces.
    signatures[edit.op].push_back(kNoIndex);
    signatures[edit.op].push_back(tracked.vertex_keys[edit.vertex]);
  }
  // An operation that declares more walls is a different operation.
  std::vector<Index> n_walls(edits.n_operations, 0);
  for (const auto& wall : edits.interior_walls) ++n_walls[wall.op];
  for (std::size_t op = 0; op < n_walls.size(); ++op) {
    if (!signatures[op].empty()) signatures[op].push_back(n_walls[op]);
  }
  return signatures;
}

std::vector<OperationHash> hashes_of(const TrackedMesh& tracked, const Edits& edits) {
  std::vector<OperationHash> hashes(edits.n_operations, OperationHash{});
  const Soup& soup = tracked.soup;
  const auto add = [&](Index op, std::initializer_list<std::uint64_t> numbers) {
    // The sum does not depend on the order in which a pass lists what it does.
    OperationHash mixed{1, 2};
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      for (const std::uint64_t number : numbers) mixed[i] = mix_hash(mixed[i], number);
      hashes[op][i] += mixed[i];
    }
  };
  const auto hash_at = [&](Index v) -> std::uint64_t {
    return v == kNoIndex ? 0 : hash_position(edits.position_of(soup, v));
  };
  const auto add_face = [&](Index op, std::uint64_t key, const Triangle& t) {
    add(op, {key, hash_at(t[0]) + hash_at(t[1]) + hash_at(t[2])});
  };
  for (const auto& edit : edits.removed_faces) {
    add_face(edit.op, 1 + std::uint64_t{tracked.face_keys[edit.face]}, soup.triangles[edit.face]);
  }
  for (const auto& edit : edits.changed_faces) {
    add_face(edit.op, 1 + std::uint64_t{tracked.face_keys[edit.face]}, soup.triangles[edit.face]);
    add_face(edit.op, 0, edit.corners);
  }
  for (const auto& edit : edits.added_faces) add_face(edit.op, 0, edit.corners);
  for (const auto& edit : edits.moved_vertices) {
    add(edit.op, {tracked.vertex_keys[edit.vertex], hash_position(edit.to)});
  }
  for (const auto& [op, wall] : edits.interior_walls) {
    add(op, {hash_position(wall.corners[0]), hash_position(wall.corners[1]),
             hash_position(wall.corners[2])});
  }
  return hashes;
}

}  // namespace meshalyzer
