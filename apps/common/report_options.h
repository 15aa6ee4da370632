#pragma once

#include "meshalyzer/io/gzip.h"
#include "option_table.h"
#include "report_target.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace meshalyzer {

/// The options of both programs for reports, progress and resources.
struct ReportOptions {
  std::optional<ReportTarget> json;
  /// The number of threads; 0 means as many as the machine has cores.
  std::size_t threads = 0;
  /// The largest allowed ratio of the unpacked size of a gzipped file to its size.
  std::uint64_t max_unpack_ratio = kDefaultUnpackRatio;
  enum class Progress : std::uint8_t { OnTerminal, Never };
  Progress progress = Progress::OnTerminal;
};

/// Declares --json.
void declare_json(OptionTable& table, ReportOptions& options);

/// Declares --max-unpack-ratio.
void declare_unpack_ratio(OptionTable& table, std::uint64_t& ratio);

/// Declares --threads, --quiet, --no-progress and --max-unpack-ratio.
void declare_conduct(OptionTable& table, ReportOptions& options);

}  // namespace meshalyzer
