#pragma once

#include "meshalyzer/checks/finding.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace meshalyzer {

/// The formats of check reports.
enum class CheckFormat : std::uint8_t { Text, Json, Ndjson, Sarif, Junit, Github };

/// Returns all formats, in the order of CheckFormat.
[[nodiscard]] std::span<const CheckFormat> all_check_formats();

/// Returns "text", "json", "ndjson", "sarif", "junit" or "github".
[[nodiscard]] std::string_view check_format_name(CheckFormat format);

/// Returns the format with the given name, or nothing if no format has it.
[[nodiscard]] std::optional<CheckFormat> check_format(std::string_view name);

/// Tells whether a text has colours, for a terminal.
enum class TextColour : std::uint8_t { Never, Always };

/// Writes the report of a check piece by piece, file by file.
class CheckReport {
 public:
  CheckReport() = default;
  CheckReport(const CheckReport&) = delete;
  CheckReport& operator=(const CheckReport&) = delete;
  virtual ~CheckReport() = default;

  virtual void add(const FileFindings& file) = 0;
  /// Ends the report.
  ///
  /// @param elapsed  How long it took; only the text says so.
  virtual void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) = 0;
};

/// Returns a report in a format.
///
/// @param sink    Receives the pieces of the text.
/// @param colour  The colours of a text; the other formats have none.
[[nodiscard]] std::unique_ptr<CheckReport> make_check_report(
    CheckFormat format, std::function<void(std::string_view)> sink,
    TextColour colour = TextColour::Never);

}  // namespace meshalyzer
