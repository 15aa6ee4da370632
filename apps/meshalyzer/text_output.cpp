#include "text_output.h"

#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/set_report.h"

#include <ostream>
#include <string>

namespace meshalyzer {

void TextOutput::on_mesh(Index, const Analysis& mesh) {
  const bool is_among_others = run_.inputs.is_set || run_.inputs.files.size() > 1;
  const bool is_verdict = mesh.goodness && run_.options.offenders == OffenderStyle::None;
  if (is_among_others && is_verdict) {
    out_ << mesh.path << ": ";
  } else if (is_among_others) {
    out_ << (n_told_ == 0 ? "" : "\n") << "==== " << mesh.path << " ====\n";
  }
  out_ << text_report(mesh, run_.options.offenders);
  ++n_told_;
}

void TextOutput::finish(const SetAnalysis* set) {
  tell_set(set, run_, out_);
}

void tell_set(const SetAnalysis* set, const Run& run, std::ostream& out) {
  if (set == nullptr || set->meshes == 0) {
    return;
  }
  const OffenderStyle offenders = run.options.offenders;
  const std::string text = run.request.between.statistics ? text_report(*set, offenders)
                                                          : text_report_between(*set, offenders);
  out << (text.empty() ? "" : "\n") << text;
}

}  // namespace meshalyzer
