#pragma once

#include "option_table.h"
#include "report_target.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace meshalyzer {

/// How both programs go about their work and tell of it.
struct ReportOptions {
  std::optional<ReportTarget> json;
  /// 0: as many as the machine has cores.
  std::size_t threads = 0;
  enum class Progress : std::uint8_t { OnTerminal, Never };
  Progress progress = Progress::OnTerminal;
};

/// --json
void declare_json(OptionTable& table, ReportOptions& options);

/// --threads, --quiet, --no-progress
void declare_conduct(OptionTable& table, ReportOptions& options);

}  // namespace meshalyzer
