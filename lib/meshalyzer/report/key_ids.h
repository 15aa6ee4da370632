#pragma once

#include "meshalyzer/report/repair_report.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// Maps the keys of a repair to file ids for people. Changes are described with the ids of the
/// input for its elements, and of the output for added ones; remaining defects with those of the
/// output only, which differ if a format numbers its records implicitly. The object only refers to
/// the report.
class KeyIds {
 public:
  explicit KeyIds(const RepairReport& report);
  explicit KeyIds(RepairReport&&) = delete;

  /// Returns the ids of a list of keys, without those of elements that were added and removed
  /// again.
  [[nodiscard]] std::vector<std::int64_t> vertices(const std::vector<Index>& keys) const;
  [[nodiscard]] std::vector<std::int64_t> faces(const std::vector<Index>& keys) const;

  /// The name of an element in the output.
  struct Final {
    /// The index into RepairReport::meshes.
    std::size_t mesh = 0;
    std::int64_t id = 0;
  };
  /// Returns the name of a vertex in the output, or nothing if it was removed or is kNoIndex.
  [[nodiscard]] std::optional<Final> final_vertex(Index key) const;
  [[nodiscard]] std::optional<Final> final_face(Index key) const;

 private:
  const MeshName& input_;
  /// The names of the vertices by key.
  std::vector<std::optional<Final>> vertices_;
  std::vector<std::optional<Final>> faces_;
};

}  // namespace meshalyzer
