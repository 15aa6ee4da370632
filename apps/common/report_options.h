#pragma once

#include "meshalyzer/io/gzip.h"
#include "option_table.h"
#include "report_target.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace meshalyzer {

/// Tells how both programs go about their work and tell of it.
struct ReportOptions {
  std::optional<ReportTarget> json;
  /// 0: as many as the machine has cores.
  std::size_t threads = 0;
  /// Tells how many times its size a gzipped file may take.
  std::uint64_t max_unpack_ratio = kDefaultUnpackRatio;
  enum class Progress : std::uint8_t { OnTerminal, Never };
  Progress progress = Progress::OnTerminal;
};

/// --json
void declare_json(OptionTable& table, ReportOptions& options);

/// --max-unpack-ratio N, of a command with these options.
void declare_unpack_ratio(OptionTable& table, std::uint64_t& ratio);

/// --threads, --quiet, --no-progress, --max-unpack-ratio
void declare_conduct(OptionTable& table, ReportOptions& options);

}  // namespace meshalyzer
