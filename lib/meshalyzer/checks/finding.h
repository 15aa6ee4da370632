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

/// Something that is wrong with a mesh: a defect, or a value beyond a limit.
struct Finding {
  /// The name of the defect code or of the limit; lives as long as the program.
  std::string_view code;
  Severity severity = Severity::Error;
  /// One sentence without full stop: which elements, and what is wrong with them.
  std::string message;
  /// Says what mends it; empty where nothing does.
  std::string_view fix;
  /// 1-based line of the record that the message names first; nothing where the format has no
  /// lines.
  std::optional<std::size_t> line;
  /// Ids of the file, those of the first elements.
  std::vector<std::int64_t> vertices;
  std::vector<std::int64_t> faces;
  static constexpr std::size_t kMaxElements = 20;
  std::optional<Vec3> position;
  /// The measured value, and the limit that it passes.
  std::optional<double> value;
  std::optional<double> limit;
};

/// Tells how often something was found.
struct FindingCount {
  std::string_view code;
  Severity severity = Severity::Error;
  /// All that were found, whether they are listed or not.
  std::size_t count = 0;
  /// Tells how many of them meshfixer mends.
  std::size_t fixable = 0;
  /// There may be more, since the search ended early.
  bool is_at_least = false;
};

/// What a check says of one file.
struct FileFindings {
  /// The path by which reports call the file.
  std::string path;
  /// Says why the file cannot be read, without its name and the place; empty where it can.
  std::string trouble;
  FilePlace trouble_place;
  /// What it was read as; nothing where it cannot be read.
  std::optional<Format> format = std::nullopt;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  /// The worst first: errors before warnings; no more of a code than the criteria list.
  std::vector<Finding> findings;
  /// One for each code that was found, in the order of the findings.
  std::vector<FindingCount> counts;

  [[nodiscard]] bool is_readable() const { return trouble.empty(); }
  [[nodiscard]] bool is_good() const { return is_readable() && counts.empty(); }
};

/// What a check says of all files together.
struct CheckTotals {
  std::size_t meshes = 0;
  std::size_t good = 0;
  std::size_t not_good = 0;
  std::size_t unreadable = 0;
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t fixable = 0;
  /// There may be more errors, since a search ended early.
  bool is_at_least = false;

  void add(const FileFindings& file);
};

}  // namespace meshalyzer
