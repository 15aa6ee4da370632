#include "meshalyzer/repair/split/internal/parting_memory.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/edits/internal/vertex_hash.h"

#include <algorithm>
#include <bit>

namespace meshalyzer {

std::optional<std::size_t> PartingMemory::recall(std::uint64_t key, std::size_t n_checks) const {
  if (n_checks == 0) return 0;
  const auto found = failed_.attempts.find(key);
  if (found == failed_.attempts.end()) return std::nullopt;
  const auto& [search, surroundings] = found->second;
  // A search that has run out of checks may end otherwise if it has more of them.
  if (search.has_run_out && n_checks > search.n_checks) return std::nullopt;
  if (hash_of_faces_in(search.region) != surroundings) return std::nullopt;
  return std::min(n_checks, search.n_checks);
}

void PartingMemory::note(std::uint64_t key, const FailedPartings::Search& search) {
  failed_.attempts.insert_or_assign(
      key,
      FailedPartings::Attempt{.search = search, .surroundings = hash_of_faces_in(search.region)});
}

std::uint64_t PartingMemory::hash_of(std::uint64_t hash, Index vertex) const {
  return hash_vertex(hash, tracked_.vertex_keys[vertex], mesh_.position(vertex));
}

std::uint64_t PartingMemory::key_of(const ContactPlace& place) const {
  auto hash = std::bit_cast<std::uint64_t>(first_step_);
  for (const auto& unit : place.units) {
    hash = mix_hash(hash, unit.size());
    for (const Index v : unit) hash = hash_of(hash, v);
  }
  for (const auto& [a, b] : place.contacts) hash = mix_hash(mix_hash(hash, a), b);
  return hash;
}

std::uint64_t PartingMemory::hash_of_faces_in(const Box3& region) const {
  std::uint64_t sum = 0;
  for (const Index face : mesh_.faces_near(region)) {
    const Triangle& t = mesh_.triangle(face);
    if (!box_of(mesh_.corners(t)).intersects(region)) continue;
    std::uint64_t hash = 0;
    for (const Index v : t) hash = hash_of(hash, v);
    sum += hash;
  }
  return sum;
}

}  // namespace meshalyzer
