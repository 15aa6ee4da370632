#include "meshalyzer/report/text/patch_lines.h"

#include "meshalyzer/report/text/patch_text.h"
#include "meshalyzer/report/text/short_list.h"

#include <cstddef>
#include <string>

namespace meshalyzer {

void append_patches(TextLines& lines, const ToldPatches& told, ListLength lists) {
  const std::size_t n = n_shown(told.patches.size(), lists);
  for (const PatchOutcome& patch : told.patches.first(n)) {
    const std::vector<Index>& faces = told.defects[patch.defect].faces;
    lines.line("patch of face " + std::to_string(told.mesh.face_ids.of(faces.front())),
               patch_text(patch, faces.size()));
  }
  if (n < told.patches.size()) {
    lines.line("not listed", counted(told.patches.size() - n, "patch", "patches"));
  }
}

}  // namespace meshalyzer
