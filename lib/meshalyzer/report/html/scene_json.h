#pragma once

#include "meshalyzer/report/html/page_mesh.h"

#include <span>
#include <string>
#include <string_view>

namespace meshalyzer {

/// A mesh on a page that may have several.
struct TitledMesh {
  /// The title, "before" or "after"; empty if it is the only mesh.
  std::string_view title;
  const PageMesh& mesh;
};

/// Returns the description of a listed defect on one line; it is never empty.
[[nodiscard]] std::string listed_defect_text(const Defect& defect, const MeshName& mesh);

/// Appends the data of the view as JSON: palettes, the colours of defects, a scene for each mesh.
/// Arrays of numbers are base64 of their little-endian bytes. The text is safe in a script element:
/// it has no '<', and no line separator that older JavaScript parsers take for the end of a line.
void append_scene_json(std::string& html, std::span<const TitledMesh> meshes);

}  // namespace meshalyzer
