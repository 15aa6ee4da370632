#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/repair_report.h"

#include <string>
#include <vector>

namespace meshalyzer::fixer {

/// The page of --find.
struct FoundPage {
  const PreparedMesh& mesh;
  const MeshName& name;
  const DefectReport& report;
  /// The codes that count in the verdict.
  const DefectCodes& asked;
};

/// Writes the page of what is wrong with a mesh.
/// @throws IoError if the file cannot be written.
void write_page(const std::string& file, const FoundPage& found);

/// Writes the page of a repair.
/// @param input   What was read.
/// @param finals  The meshes of the report, as they are.
/// @throws IoError if the file cannot be written.
void write_page(const std::string& file, const RepairReport& report, const Soup& input,
                const std::vector<Soup>& finals);

}  // namespace meshalyzer::fixer
