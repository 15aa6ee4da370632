#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/set/separation.h"
#include "meshalyzer/set/shard.h"

#include <cstdint>
#include <optional>

namespace meshalyzer {

/// What to find out between the meshes of a set.
struct SetQuestions {
  /// Which faces of different meshes share a point, and which meshes are inside others (-i).
  bool intersections = false;
  /// How far each vertex is from the closest other mesh (-s).
  std::optional<SeparationOptions> separation = std::nullopt;
  /// The statistics over the faces, edges and vertices of all meshes.
  bool statistics = true;
  /// Measure separation although a mesh is not good (--force).
  bool force = false;

  /// Whether any of it is about what lies between the meshes.
  [[nodiscard]] bool is_between() const { return intersections || separation; }
};

/// How to analyse a set.
struct SetOptions {
  /// What to do for each mesh.
  AnalysisOptions analysis;
  SetQuestions questions;
  /// Bytes to stay below where the largest few meshes allow it; objects are read again when they
  /// had to be forgotten.
  std::uint64_t memory_limit = 0;
  Shard shard;
};

}  // namespace meshalyzer
