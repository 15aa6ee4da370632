#include "json_output.h"

#include <ostream>

namespace meshalyzer {
namespace {

std::optional<FileReplacement> open(const ReportTarget& target) {
  return target.is_stdout() ? std::nullopt : std::optional<FileReplacement>(target.file);
}

}  // namespace

JsonOutput::JsonOutput(const Run& run, std::ostream& out)
    : run_(run),
      file_(open(*run.options.json)),
      report_(
          [this, &out](std::string_view text) {
            if (file_) {
              file_->write(text);
            } else {
              out << text;
            }
          },
          run.request.list_offenders ? JsonOffenders::List : JsonOffenders::Omit) {}

void JsonOutput::on_mesh(Index, const Analysis& mesh) {
  report_.add(mesh);
}

void JsonOutput::on_unreadable(Index number, const std::string& why) {
  report_.add_unreadable(run_.inputs.files[number], why);
}

void JsonOutput::on_findings(const ObjectFindings& findings) {
  report_.add(findings, run_.inputs.names);
}

void JsonOutput::finish(const SetAnalysis* set) {
  report_.finish(set);
  if (file_) {
    file_->commit();
  }
}

}  // namespace meshalyzer
