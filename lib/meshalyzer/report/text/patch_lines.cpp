#include "meshalyzer/report/text/patch_lines.h"

#include "meshalyzer/report/text/short_list.h"

#include <string>

namespace meshalyzer {
namespace {

std::string passes_text(const PatchOutcome& patch) {
  std::string text;
  for (const std::string& pass : patch.passes) {
    text += text.empty() ? " by " : ", ";
    text += pass;
  }
  return text;
}

std::string outcome_text(const PatchOutcome& patch, std::size_t n_faces) {
  std::string text = counted(n_faces, "face", "faces");
  text += patch.is_mended ? "; mended" : patch.passes.empty() ? "; left" : "; changed";
  text += passes_text(patch);
  if (!patch.passes.empty()) text += "; moved by at most " + readable(patch.distance);
  if (patch.is_mended) return text;
  text += "; still intersects: ";
  text += patch.reason;
  return text;
}

}  // namespace

void append_patches(TextLines& lines, const ToldPatches& told, ListLength lists) {
  const std::size_t n = n_shown(told.patches.size(), lists);
  for (const PatchOutcome& patch : told.patches.first(n)) {
    const std::vector<Index>& faces = told.defects[patch.defect].faces;
    lines.line("patch of face " + std::to_string(told.mesh.face_ids.of(faces.front())),
               outcome_text(patch, faces.size()));
  }
  if (n < told.patches.size()) {
    lines.line("not listed", counted(told.patches.size() - n, "patch", "patches"));
  }
}

}  // namespace meshalyzer
