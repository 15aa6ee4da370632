#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "meshalyzer/repair/split/internal/contact_places.h"
#include "meshalyzer/repair/split/internal/moved_faces.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace meshalyzer {

// Private to part_contacts().

/// The places where no vertex could be moved, from all runs of the pass.
struct FailedPartings {
  /// A search for a move that found none.
  struct Search {
    /// A box that all faces meet on which the outcome depends.
    Box3 region;
    /// The number of pairs of faces that were checked.
    std::size_t n_checks = 0;
    /// Tells whether the search ended because no more pairs were allowed to be checked.
    bool has_run_out = false;
  };
  struct Attempt {
    Search search;
    /// A hash of the faces that met the region.
    std::uint64_t surroundings = 0;
  };

  /// By PartingMemory::key_of().
  std::unordered_map<std::uint64_t, Attempt> attempts;
};

/// Tells at which places of a mesh a move was searched for in vain before, and where all faces that
/// matter are the same as then, so that to search again would be in vain too. The pass runs again
/// and again, while few faces change.
class PartingMemory {
 public:
  /// @param failed      What is known; all of it from meshes of one repair.
  /// @param tracked     Must outlive this, as must the mesh.
  /// @param mesh        The same mesh with what has been moved since.
  /// @param first_step  The shortest move that is tried. A length.
  PartingMemory(FailedPartings& failed, const TrackedMesh& tracked, const MovedMesh& mesh,
                double first_step)
      : failed_(failed), tracked_(tracked), mesh_(mesh), first_step_(first_step) {}

  /// Returns a hash that stands for a place until one of its vertices is moved.
  [[nodiscard]] std::uint64_t key_of(const ContactPlace& place) const;

  /// Tells whether a place, by its key, has failed before, with whatever faces near it.
  [[nodiscard]] bool has_failed(std::uint64_t key) const {
    return failed_.attempts.count(key) != 0;
  }

  /// Returns the number of pairs that a search at a place, by its key, would check in vain; nothing
  /// if that is not known.
  ///
  /// @param n_checks     The number of pairs that may be checked.
  /// @complexity         O(log #F + k), k the number of faces in the region of the search.
  [[nodiscard]] std::optional<std::size_t> recall(std::uint64_t key, std::size_t n_checks) const;

  /// Notes that a search at a place, by its key, has found no move.
  void note(std::uint64_t key, const FailedPartings::Search& search);

 private:
  [[nodiscard]] std::uint64_t hash_of(std::uint64_t hash, Index vertex) const;
  [[nodiscard]] std::uint64_t hash_of_faces_in(const Box3& region) const;

  FailedPartings& failed_;
  const TrackedMesh& tracked_;
  const MovedMesh& mesh_;
  double first_step_;
};

}  // namespace meshalyzer
