#include "meshalyzer/checks/known_findings.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the normal form of a path: "./a.ply" becomes "a.ply".
std::string normal(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

bool is_same_place(const std::optional<Vec3>& a, const std::optional<Vec3>& b) {
  constexpr double kMillionth = 1e-6;
  if (!a || !b) return a.has_value() == b.has_value();
  return (*a - *b).cwiseAbs().maxCoeff() <= kMillionth * a->cwiseAbs().maxCoeff();
}

/// Removes one finding from the counts.
void uncount(const Finding& finding, std::vector<FindingCount>& counts) {
  const auto found = std::find_if(counts.begin(), counts.end(), [&](const FindingCount& count) {
    return count.code == finding.code;
  });
  --found->count;
  found->fixable -= finding.fix.empty() ? 0 : 1;
  if (found->count == 0) counts.erase(found);
}

/// Returns the number of lines of a file if this many findings of a code are listed.
std::size_t n_lines(const FileFindings& file, std::size_t max_listed) {
  std::size_t lines = 0;
  for (const FindingCount& found : file.counts) {
    const bool has_rest = found.count > max_listed || found.is_at_least;
    lines += std::min(found.count, max_listed) + (has_rest ? 1 : 0);
  }
  return lines;
}

}  // namespace

std::vector<KnownFinding> known_of(const FileFindings& file) {
  std::vector<KnownFinding> known;
  for (const Finding& finding : file.findings) {
    known.push_back({file.path, std::string(finding.code), finding.position});
  }
  return known;
}

KnownFindings::KnownFindings(const std::vector<KnownFinding>& known) {
  for (const KnownFinding& finding : known) {
    places_[{normal(finding.path), finding.code}].push_back(finding.position);
  }
}

bool KnownFindings::accept(const std::string& path, const Finding& finding) {
  const auto places = places_.find({path, std::string(finding.code)});
  if (places == places_.end()) return false;
  const auto place =
      std::find_if(places->second.begin(), places->second.end(),
                   [&](const auto& each) { return is_same_place(each, finding.position); });
  if (place == places->second.end()) return false;
  places->second.erase(place);
  return true;
}

void KnownFindings::drop_from(FileFindings& file) {
  const std::string path = normal(file.path);
  std::erase_if(file.findings, [&](const Finding& finding) {
    const bool is_known = accept(path, finding);
    if (is_known) uncount(finding, file.counts);
    return is_known;
  });
}

void cut_listed(FileFindings& file, std::size_t max_listed, std::size_t max_lines) {
  if (max_listed == 0) return;
  while (max_lines != 0 && max_listed > 0 && n_lines(file, max_listed) > max_lines) --max_listed;
  std::map<std::string_view, std::size_t> n_listed;
  std::erase_if(file.findings,
                [&](const Finding& finding) { return ++n_listed[finding.code] > max_listed; });
}

}  // namespace meshalyzer
