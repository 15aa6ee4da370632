#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/report/mesh_name.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {

/// A resulting mesh, as it is on disk, or would be.
struct FinalMesh {
  /// The name; its path is empty if the mesh was not written.
  MeshName name;
  /// The defects that remain, by the records of the file.
  DefectReport remaining;
  /// The record in the file of each vertex of the result's tracked mesh, kNoIndex if it has none;
  /// empty if they are the same.
  std::vector<Index> vertex_records = {};
  /// The record in the file of each face of the tracked mesh; empty if they are the same.
  std::vector<Index> face_records = {};

  /// Returns the id that the file gives to a face of the tracked mesh.
  [[nodiscard]] std::int64_t face_id(Index face) const {
    return name.face_ids.of(face_records.empty() ? face : face_records[face]);
  }
};

/// A repair from beginning to end, for reports. It only refers to the result.
struct RepairReport {
  /// The mesh that was repaired.
  MeshName input;
  const RepairResult& result;
  /// The defects that were to be fixed.
  DefectCodes fixes;
  /// One for each mesh of the result.
  std::vector<FinalMesh> meshes;
  /// Sentences that a person should read, such as that an encoding was changed.
  std::vector<std::string> notes;
  /// The attributes of the input that the written files lose although no change dropped them.
  std::vector<AttributeCount> lost = {};
};

/// The defects of a mesh that is not repaired, for reports. The struct only refers to its data.
struct FoundDefects {
  const MeshName& mesh;
  const DefectReport& defects;
  /// The codes that count; others are listed too, and marked as not requested.
  const DefectCodes& requested;
  /// The outcome of a repair for each self-intersection; empty if none was tried.
  std::span<const PatchOutcome> patches = {};
};

/// The patches of intersecting faces and the outcome for each. The struct only refers to them.
struct PatchReport {
  const MeshName& mesh;
  /// The defects of the mesh, among which the patches are.
  const DefectList& defects;
  std::span<const PatchOutcome> patches;
};

/// Returns the number of vertices of all resulting meshes together.
[[nodiscard]] std::size_t n_final_vertices(const RepairReport& report);
[[nodiscard]] std::size_t n_final_faces(const RepairReport& report);

/// Returns the number of remaining defects of some codes.
[[nodiscard]] std::size_t n_remaining(const RepairReport& report, const DefectCodes& codes);

/// Returns the number of remaining defects that were to be fixed.
[[nodiscard]] std::size_t n_remaining(const RepairReport& report);

/// Tells whether more of them may remain, because a search ended early.
[[nodiscard]] bool may_have_more(const RepairReport& report);

/// Tells whether it is certain that none of them remains.
[[nodiscard]] bool nothing_remains(const RepairReport& report);

}  // namespace meshalyzer
