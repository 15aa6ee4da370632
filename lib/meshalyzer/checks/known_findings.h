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

/// A finding of an earlier check. It is known again by its file, code and place, since numbers
/// change whenever a mesh is written anew.
struct KnownFinding {
  std::string path;
  std::string code;
  std::optional<Vec3> position;
};

/// Returns what a later check knows of the findings of a file.
[[nodiscard]] std::vector<KnownFinding> known_of(const FileFindings& file);

/// Findings that are accepted.
class KnownFindings {
 public:
  explicit KnownFindings(const std::vector<KnownFinding>& known);

  /// Takes the known findings out of those of a file, so that only new ones are left. Each known
  /// one accepts one finding, at a distance of at most a millionth of its coordinates.
  ///
  /// @param file  Must list all its findings.
  void drop_from(FileFindings& file);

 private:
  [[nodiscard]] bool accept(const std::string& path, const Finding& finding);

  /// The places of the known findings, by normal path and code.
  std::map<std::pair<std::string, std::string>, std::vector<std::optional<Vec3>>> places_;
};

/// Leaves no more findings of a code in the list than so many; counts stay.
///
/// @param max_listed  0 leaves all.
/// @param max_lines   So many lines at most, one a finding and one for those of a code that are
/// left out: where there would be more, fewer of each code are left. 0: no limit.
void cut_listed(FileFindings& file, std::size_t max_listed, std::size_t max_lines = 0);

}  // namespace meshalyzer
