#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/repair_report.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer::fixer {

/// The input of the page of --find, or of a solid that was combined of others.
struct FoundPage {
  const MeshName& name;
  const DefectReport& report;
  /// The codes that count in the verdict.
  const DefectCodes& requested;
  const Scene& scene;
  /// The outcome of a repair for each patch of intersecting faces; empty if none was tried.
  std::span<const PatchOutcome> patches = {};
};

/// Writes the page of the defects of a mesh.
/// @throws IoError if the file cannot be written.
void write_page(const std::string& file, const FoundPage& found);

/// Decides what a page draws of a mesh and its defects.
[[nodiscard]] Scene scene_of(const PreparedMesh& mesh, const DefectReport& defects);

/// A mesh that a repair has made, as it is on disk.
struct FinalSoup {
  std::shared_ptr<const Soup> soup;
  /// The prepared form of the same vertices and triangles; null if it was not needed yet.
  std::shared_ptr<const PreparedMesh> prepared;
};

/// The input of a repair, and its drawn scene.
struct DrawnInput {
  std::shared_ptr<const PreparedMesh> mesh;
  Scene scene;
};

/// Writes the page of a repair.
/// @param finals  The meshes of the report.
/// @throws IoError if the file cannot be written.
void write_page(const std::string& file, const RepairReport& report, DrawnInput before,
                const std::vector<FinalSoup>& finals);

}  // namespace meshalyzer::fixer
