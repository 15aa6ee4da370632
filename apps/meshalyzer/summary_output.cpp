#include "summary_output.h"

#include "meshalyzer/report/text/summary_table.h"
#include "terminal.h"
#include "text_output.h"

#include <ostream>

namespace meshalyzer {

SummaryOutput::SummaryOutput(const Run& run, std::ostream& out)
    : run_(run),
      out_(out),
      name_width_(summary_width(run.inputs.names,
                                is_terminal(out) ? NameLength::Fitted : NameLength::Whole)) {
  out_ << summary_header(name_width_);
}

void SummaryOutput::on_mesh(Index number, const Analysis& mesh) {
  out_ << summary_line(run_.inputs.names[number], mesh, name_width_);
}

void SummaryOutput::on_unreadable(Index number, const std::string& why) {
  out_ << summary_of_unreadable(run_.inputs.names[number], why, name_width_);
}

void SummaryOutput::finish(const SetAnalysis* set) {
  tell_set(set, run_, out_);
}

}  // namespace meshalyzer
