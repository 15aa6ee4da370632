#include "journal.h"

#include <filesystem>
#include <ostream>

namespace meshalyzer {

Journal::Journal(const Options& options, const Inputs& inputs, const Request& request)
    : subject_{stamped(inputs.files), request}, known_(subject_) {
  if (options.resume) {
    known_.add(*options.resume);
  } else if (std::filesystem::is_regular_file(options.ndjson->file)) {
    known_.add(options.ndjson->file);
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
