#include "meshalyzer/report/text/patch_lines.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/text/patch_text.h"
#include "meshalyzer/report/text/short_list.h"

#include <cstddef>
#include <string>

namespace meshalyzer {

void append_patches(TextLines& lines, const PatchReport& report, ListLength lists) {
  const std::size_t n = n_shown(report.patches.size(), lists);
  for (const PatchOutcome& patch : report.patches.first(n)) {
    const std::vector<Index>& faces = report.defects[patch.defect].faces;
    lines.line("patch of face " + std::to_string(report.mesh.face_ids.of(faces.front())),
               patch_text(patch, faces.size()));
  }
  if (n < report.patches.size()) {
    lines.line("not listed", counted(report.patches.size() - n, "patch", "patches"));
  }
}

}  // namespace meshalyzer
