#include "meshalyzer/set/analyze_files.h"

#include "meshalyzer/set/file_run.h"
#include "meshalyzer/set/require_options.h"

namespace meshalyzer {

bool analyze_files(const std::vector<std::string>& paths, const SetOptions& options,
                   RunListener& listener) {
  require_valid(options);
  const Deadline deadline(options.request.time_limit);
  const bool is_whole =
      FileRun(paths, options, listener, deadline).run([](Index, const FileResult&) {});
  return is_whole && options.shard.count == 1;
}

}  // namespace meshalyzer
