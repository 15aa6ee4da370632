#include "meshalyzer/report/text/patch_text.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/text/lines.h"

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

}  // namespace

std::string patch_text(const PatchOutcome& patch, std::size_t n_faces) {
  std::string text = counted(n_faces, "face", "faces");
  text += patch.is_mended ? "; mended" : patch.passes.empty() ? "; left" : "; changed";
  text += passes_text(patch);
  if (!patch.passes.empty()) text += "; moved by at most " + readable(patch.distance);
  if (patch.is_mended) return text;
  text += "; still intersects: ";
  text += patch.reason;
  return text;
}

}  // namespace meshalyzer
