#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/fix_defects.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// What a report calls a mesh and its elements.
struct MeshName {
  /// As the user named it.
  std::string path;
  Format format = Format::Mesh;
  Ids vertex_ids;
  Ids face_ids;
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
};

[[nodiscard]] MeshName name_of(const Soup& soup, std::string path);

/// A mesh that came out, as it is on disk, or would be.
struct FinalMesh {
  /// The path is empty where it was not written.
  MeshName name;
  /// By the records of the file.
  DefectReport remaining;
  /// By vertex of the result's tracked mesh: its record in the file, kNoIndex where it has none.
  /// Empty where they are the same.
  std::vector<Index> vertex_records = {};
};

/// A repair from beginning to end, for reports. Only refers to the result.
struct RepairReport {
  /// What was repaired.
  MeshName input;
  const RepairResult& result;
  /// What was asked for.
  DefectCodes fixes;
  /// One for each mesh of the result; their faces are in the same order.
  std::vector<FinalMesh> meshes;
  /// Sentences that a person should read, such as that an encoding was changed.
  std::vector<std::string> notes;
};

/// How many of the defects of a mesh are of the codes that count.
[[nodiscard]] std::size_t n_asked(const DefectReport& report, const DefectCodes& asked);

/// How many of the defects that were to be fixed are left.
[[nodiscard]] std::size_t n_remaining(const RepairReport& report);

}  // namespace meshalyzer
