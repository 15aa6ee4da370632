#pragma once

#include "meshalyzer/report/repair_report.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// The file ids that the keys of a repair mean to a person. What was done is told by the ids of the
/// input for what was there, of the output for what was added; what remains by those of the output
/// alone, which are others where a format numbers its records silently. Only refers to the report.
class KeyIds {
 public:
  explicit KeyIds(const RepairReport& report);
  explicit KeyIds(RepairReport&&) = delete;

  /// Returns the ids of a list of keys, without those that were added and are gone again.
  [[nodiscard]] std::vector<std::int64_t> vertices(const std::vector<Index>& keys) const;
  [[nodiscard]] std::vector<std::int64_t> faces(const std::vector<Index>& keys) const;

  /// The name of an element in the end.
  struct Final {
    /// Index into RepairReport::meshes.
    std::size_t mesh = 0;
    std::int64_t id = 0;
  };
  /// Returns the name of a vertex in the end; nothing where it is gone, and for kNoIndex.
  [[nodiscard]] std::optional<Final> final_vertex(Index key) const;
  [[nodiscard]] std::optional<Final> final_face(Index key) const;

 private:
  const MeshName& input_;
  /// The names by key.
  std::vector<std::optional<Final>> vertices_;
  std::vector<std::optional<Final>> faces_;
};

}  // namespace meshalyzer
