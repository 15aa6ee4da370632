#include "meshalyzer/repair/holes/internal/fill_memory.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/edits/internal/vertex_hash.h"
#include "meshalyzer/repair/holes/internal/corner_numbers.h"

namespace meshalyzer {

std::optional<Filling> FillMemory::recall(const HoleLoop& loop) {
  std::optional<FailedFillings::Attempt> attempt = known_attempt(hash_of(loop));
  if (!attempt || hash_of_faces_in(attempt->region) != attempt->surroundings) return std::nullopt;
  Filling filling{.patch = {}, .reason = std::move(attempt->reason), .first = {}};
  if (attempt->first) {
    filling.first = Patch{.triangles = at_vertices(*attempt->first, loop.vertices), .added = {}};
  }
  return filling;
}

std::optional<FailedFillings::Attempt> FillMemory::known_attempt(std::uint64_t loop) {
  const std::lock_guard lock(mutex_);
  const auto found = failed_.attempts.find(loop);
  if (found == failed_.attempts.end()) return std::nullopt;
  return found->second;
}

void FillMemory::note(const HoleLoop& loop, const Box3& region, const Filling& filling) {
  FailedFillings::Attempt attempt{.region = region,
                                  .surroundings = hash_of_faces_in(region),
                                  .reason = filling.reason,
                                  .first = std::nullopt};
  if (filling.first) attempt.first = CornerNumbers(loop.vertices).of(filling.first->triangles);
  const std::uint64_t hash = hash_of(loop);
  const std::lock_guard lock(mutex_);
  failed_.attempts.insert_or_assign(hash, std::move(attempt));
}

std::uint64_t FillMemory::hash_of(std::uint64_t hash, Index vertex) const {
  const TrackedMesh& tracked = input_.tracked;
  return hash_vertex(hash, tracked.vertex_keys[vertex], tracked.soup.positions[vertex]);
}

std::uint64_t FillMemory::hash_of(const HoleLoop& loop) const {
  std::uint64_t hash = loop.size();
  for (const Index v : loop.vertices) hash = hash_of(hash, v);
  return hash;
}

std::uint64_t FillMemory::hash_of_faces_in(const Box3& region) {
  const HashedFaces& faces = faces_.get([&] { return hash_faces(); });
  std::uint64_t sum = 0;
  for (const Index face : faces.tree.meeting(region)) sum += faces.hashes[face];
  return sum;
}

FillMemory::HashedFaces FillMemory::hash_faces() const {
  const Soup& soup = input_.tracked.soup;
  std::vector<Box3> boxes(soup.n_faces());
  std::vector<std::uint64_t> hashes(soup.n_faces(), 0);
  for (Index face = 0; face < soup.n_faces(); ++face) {
    const Triangle& t = soup.triangles[face];
    if (!is_in_complex(t)) continue;
    boxes[face] = box_of(corners_of(soup, face));
    for (const Index v : t) hashes[face] = hash_of(hashes[face], v);
  }
  return {.tree = BoxTree(boxes), .hashes = std::move(hashes)};
}

}  // namespace meshalyzer
