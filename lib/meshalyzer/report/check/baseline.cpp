#include "meshalyzer/report/check/baseline.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/point.h"
#include "meshalyzer/report/json/tree.h"

#include <cstddef>

namespace meshalyzer {
namespace {

std::size_t n_counted(const JsonNode& mesh) {
  std::size_t n = 0;
  for (JsonElements counts = mesh.member("counts").elements(); !counts.at_end();) {
    n += counts.next().member("count").count();
  }
  return n;
}

/// Appends the findings of one mesh.
void read_findings(const JsonNode& mesh, std::vector<KnownFinding>& known) {
  const std::string path = read_bytes(mesh, "path");
  const std::size_t n_before = known.size();
  for (JsonElements findings = mesh.member("findings").elements(); !findings.at_end();) {
    const JsonNode finding = findings.next();
    const JsonNode position = finding.member("position");
    known.push_back({path, std::string(finding.member("code").text()),
                     position.is_null() ? std::nullopt : std::optional(read_point(position))});
  }
  if (known.size() - n_before != n_counted(mesh)) {
    mesh.refuse("not all findings are listed");
  }
}

}  // namespace

std::vector<KnownFinding> read_baseline(const std::string& path) {
  const FileContent content(path);
  try {
    const JsonTree tree(content.bytes());
    std::vector<KnownFinding> known;
    for (JsonElements meshes = tree.root().member("meshes").elements(); !meshes.at_end();) {
      read_findings(meshes.next(), known);
    }
    return known;
  } catch (const InvalidArgument& error) {
    throw IoError(path, {}, std::string("no baseline: ") + error.what());
  }
}

}  // namespace meshalyzer
