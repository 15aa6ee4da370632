#include "journal.h"

#include "file_identity.h"

#include <filesystem>
#include <ostream>

namespace meshalyzer {

Journal::Journal(const Options& options, const Inputs& inputs, const Request& request)
    : subject_{stamped(inputs.files), request}, known_(subject_) {
  const ReportTarget& target = *options.ndjson;
  if (options.resume) known_.add(*options.resume);
  const bool is_resumed = options.resume && is_same_file(*options.resume, target.file);
  if (!target.is_stdout() && !is_resumed && std::filesystem::is_regular_file(target.file)) {
    known_.add(target.file);
  }
}

void Journal::open(const ReportTarget& target, std::ostream& out) {
  if (target.is_stdout()) {
    known_.write([&](std::string_view line) { out << line; });
    recorder_.emplace(subject_, known_,
                      [&out](std::string_view line) { out << line << std::flush; });
  } else {
    file_.emplace(target.file, known_);
    recorder_.emplace(subject_, known_, [this](std::string_view line) { file_->append(line); });
  }
}

}  // namespace meshalyzer
