#include "json_output.h"

#include <ostream>

namespace meshalyzer {
namespace {

std::optional<FileReplacement> open(const ReportTarget& target) {
  return target.is_stdout() ? std::nullopt : std::optional<FileReplacement>(target.file);
}

}  // namespace

JsonOutput::JsonOutput(const ReportTarget& target, JsonOffenders offenders, std::ostream& out)
    : file_(open(target)),
      report_(
          [this, &out](std::string_view text) {
            if (file_) {
              file_->write(text);
            } else {
              out << text;
            }
          },
          offenders) {}

void JsonOutput::finish(const SetAnalysis* set) {
  report_.finish(set);
  if (file_) {
    file_->commit();
  }
}

}  // namespace meshalyzer
