#include "report_options.h"

#include "arguments.h"

namespace meshalyzer {

void declare_json(OptionTable& table, ReportOptions& options) {
  table.option_or("-", "--json[=FILE]", into(options.json),
                  "the report as JSON in place of text; with FILE, as JSON in FILE and as text");
}

void declare_unpack_ratio(OptionTable& table, std::uint64_t& ratio) {
  table.option("--max-unpack-ratio N", into(ratio, to_count_from_one),
               "refuse a .gz that takes more than N times its size (1000)");
}

void declare_conduct(OptionTable& table, ReportOptions& options) {
  const auto be_quiet = [&options] { options.progress = ReportOptions::Progress::Never; };
  table.option("--threads N", into(options.threads, to_thread_count),
               "use at most N threads; 0, the default: one for each core");
  table.flag("--quiet", be_quiet, "write only errors to standard error");
  table.flag("--no-progress", be_quiet,
             "show no progress on standard error (it is shown only on "
             "a terminal)");
  declare_unpack_ratio(table, options.max_unpack_ratio);
}

}  // namespace meshalyzer
