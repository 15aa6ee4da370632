#pragma once

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/types.h"
#include "meshalyzer/defects/defect.h"
#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A fault of a mesh: a defect, or a value beyond a limit.
struct Finding {
  /// The name of the defect code or of the limit, with static lifetime.
  std::string_view code;
  Severity severity = Severity::Error;
  /// A sentence without full stop that says which elements are concerned and what is wrong with
  /// them.
  std::string message;
  /// Says what mends it; empty if nothing does.
  std::string_view fix;
  /// The 1-based line of the record that the message names first; nothing if the format has no
  /// lines.
  std::optional<std::size_t> line;
  /// The ids in the file of the first elements.
  std::vector<std::int64_t> vertices;
  std::vector<std::int64_t> faces;
  static constexpr std::size_t kMaxElements = 20;
  std::optional<Vec3> position;
  /// The measured value, and the limit that it passes.
  std::optional<double> value;
  /// Tells whether the value is a lower bound, because the search ended early.
  bool is_at_least = false;
  std::optional<double> limit;
};

/// The number of findings of a code.
struct FindingCount {
  std::string_view code;
  Severity severity = Severity::Error;
  /// The number of all findings, listed or not.
  std::size_t count = 0;
  /// The number of findings that meshfixer mends.
  std::size_t fixable = 0;
  /// Tells whether the search ended early, so that there may be more.
  bool is_at_least = false;
};

/// The result of a check of one file.
struct FileFindings {
  /// The name of the file in reports.
  std::string path;
  /// Says why the file cannot be read, without its name and the place; empty if it can.
  std::string error;
  FilePlace error_place;
  /// The format of the file; nothing if it cannot be read.
  std::optional<Format> format = std::nullopt;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  /// The findings, errors before warnings, with at most as many of a code as the criteria allow.
  std::vector<Finding> findings;
  /// The counts, one for each code that was found, in the order of the findings.
  std::vector<FindingCount> counts;

  [[nodiscard]] bool is_readable() const { return error.empty(); }
  [[nodiscard]] bool is_good() const { return is_readable() && counts.empty(); }
};

/// The result of a check of all files together.
struct CheckTotals {
  std::size_t meshes = 0;
  std::size_t good = 0;
  std::size_t not_good = 0;
  std::size_t unreadable = 0;
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t fixable = 0;
  /// Tells whether a search ended early, so that there may be more errors.
  bool is_at_least = false;

  void add(const FileFindings& file);
};

}  // namespace meshalyzer
