#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/checks/finding.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// A finding of an earlier check. It is recognised by its file, code and position, since ids change
/// when a mesh is rewritten.
struct KnownFinding {
  std::string path;
  std::string code;
  std::optional<Vec3> position;
};

/// Returns the findings of a file in the form that a later check compares with.
[[nodiscard]] std::vector<KnownFinding> known_of(const FileFindings& file);

/// The findings that are accepted.
class KnownFindings {
 public:
  explicit KnownFindings(const std::vector<KnownFinding>& known);

  /// Removes the known findings from those of a file, so that only new ones are left. Each known
  /// one accepts one finding at a distance of at most a millionth of its coordinates.
  ///
  /// @param file  The findings of the file, all of which must be listed.
  void drop_from(FileFindings& file);

 private:
  [[nodiscard]] bool accept(const std::string& path, const Finding& finding);

  /// The positions of the known findings, by normal path and code.
  std::map<std::pair<std::string, std::string>, std::vector<std::optional<Vec3>>> places_;
};

/// Limits the number of listed findings of a code; counts stay.
///
/// @param max_listed  The largest number of findings of a code; 0 means no limit.
/// @param max_lines   The largest number of lines: one for each finding, and one for the omitted
///     findings of a code. If there would be more, fewer of each code are listed. 0 means no limit.
void cut_listed(FileFindings& file, std::size_t max_listed, std::size_t max_lines = 0);

}  // namespace meshalyzer
