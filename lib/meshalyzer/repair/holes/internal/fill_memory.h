#pragma once

#include "meshalyzer/base/lazy.h"
#include "meshalyzer/repair/holes/internal/fill_loop.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/spatial/box_tree.h"

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace meshalyzer {

/// The loops for which no patch was found, from all runs of a pass.
struct FailedFillings {
  struct Attempt {
    /// The box of all patches that were tried, and a hash of the faces that met it.
    Box3 region;
    std::uint64_t surroundings = 0;
    std::string reason;
    /// The first patch, by the numbers of the loop's corners.
    std::optional<std::vector<Triangle>> first;
  };

  /// By a hash of the loop.
  std::unordered_map<std::uint64_t, Attempt> attempts;
};

/// Tells which loops of a mesh were tried in vain before, while all that could meet their patches
/// was the same: to try them again would be in vain too. Passes try to fill holes again and again,
/// while few faces change. Any number of threads may ask at a time.
class FillMemory {
 public:
  /// @param failed  What is known; all of it from meshes of one repair, and one set of options.
  /// @param input   Must outlive this.
  FillMemory(FailedFillings& failed, const PassInput& input) : failed_(failed), input_(input) {}

  /// Returns the outcome of filling a loop if it is known that there is no patch.
  ///
  /// @complexity  O(n + log #F + k), k the number of faces round the loop; O(#F log #F) more once.
  [[nodiscard]] std::optional<Filling> recall(const HoleLoop& loop);

  /// Notes that no patch was found.
  ///
  /// @param region  The box of all patches that were tried.
  void note(const HoleLoop& loop, const Box3& region, const Filling& filling);

 private:
  /// The faces of the mesh, by their boxes.
  struct HashedFaces {
    BoxTree tree;
    std::vector<std::uint64_t> hashes;
  };

  [[nodiscard]] std::uint64_t hash_of(std::uint64_t hash, Index vertex) const;
  [[nodiscard]] std::uint64_t hash_of(const HoleLoop& loop) const;
  [[nodiscard]] std::uint64_t hash_of_faces_in(const Box3& region);
  /// Returns what is known of the loop with a hash.
  [[nodiscard]] std::optional<FailedFillings::Attempt> known_attempt(std::uint64_t loop);
  [[nodiscard]] HashedFaces hash_faces() const;

  /// Guards what is known.
  std::mutex mutex_;
  FailedFillings& failed_;
  const PassInput& input_;
  Lazy<HashedFaces> faces_;
};

}  // namespace meshalyzer
