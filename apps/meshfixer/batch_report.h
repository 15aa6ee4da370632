#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/io/file_replacement.h"
#include "meshalyzer/report/repair_report.h"
#include "options.h"
#include "streams.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace meshalyzer::fixer {

/// Reports the files of a batch as text, JSON and NDJSON.
class BatchReport {
 public:
  /// @throws IoError if a file of a report cannot be written.
  BatchReport(const Options& options, Streams streams);

  /// Reports a repaired file.
  /// @param path  The path as the user named it.
  void add(const std::string& path, const RepairReport& report);
  /// Reports a file that could not be read or written.
  void add_error(const std::string& path, const std::string& what);

  /// Ends the reports.
  void finish();

 private:
  using Counts = std::array<std::size_t, kDefectCodes>;

  void add_json(const std::string& report);
  void say(const std::string& text);
  [[nodiscard]] std::string table() const;

  Streams streams_;
  /// Full lists need the whole report of each file in place of a line.
  ListLength lists_;
  /// False if standard output is for JSON.
  bool has_text_;
  std::optional<FileReplacement> json_;
  std::optional<FileReplacement> ndjson_;
  bool has_json_ = false;
  bool json_is_stdout_ = false;
  bool ndjson_is_stdout_ = false;
  std::size_t n_files_ = 0;
  std::size_t n_changed_ = 0;
  std::size_t n_with_rest_ = 0;
  std::size_t n_errors_ = 0;
  Counts before_{};
  Counts after_{};
  std::vector<AttributeCount> lost_;
};

}  // namespace meshalyzer::fixer
