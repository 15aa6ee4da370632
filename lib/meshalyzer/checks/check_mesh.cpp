#include "meshalyzer/checks/check_mesh.h"

#include "meshalyzer/checks/defect_sentence.h"
#include "meshalyzer/checks/known_findings.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/mesh/finite_positions.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the ids of the first few records of a list.
std::vector<std::int64_t> first_ids(const std::vector<Index>& records, const Ids& ids) {
  std::vector<std::int64_t> first;
  for (const Index record : records) {
    if (first.size() == Finding::kMaxElements) break;
    first.push_back(ids.of(record));
  }
  return first;
}

/// Returns the vertices of a defect: those it lists, else the ends of its edges.
std::vector<Index> vertices_of(const Defect& defect) {
  std::vector<Index> vertices = defect.vertices;
  for (const auto& edge : defect.edges) {
    if (vertices.size() >= Finding::kMaxElements) break;
    vertices.insert(vertices.end(), edge.begin(), edge.end());
  }
  return vertices;
}

Finding finding_of(const Defect& defect, const Soup& soup, bool is_at_least) {
  const CatalogueEntry& entry = catalogue_entry(defect.code);
  Finding finding{.code = entry.name,
                  .severity = defect.severity,
                  .message = defect_sentence(defect, soup, is_at_least),
                  .fix = defect.fixable ? entry.fix_summary : "",
                  .line = defect_line(defect, soup),
                  .vertices = first_ids(vertices_of(defect), soup.vertex_ids),
                  .faces = first_ids(defect.faces, soup.face_ids),
                  .position = std::nullopt,
                  .value = defect.value,
                  .is_at_least = is_at_least,
                  .limit = defect.limit};
  if (!defect.positions.empty()) finding.position = defect.positions.front();
  return finding;
}

/// Returns "edge 1-2: ", "face 3: ", or an empty text for the whole mesh.
std::string subject_of(const LimitViolation& violation, const Soup& soup) {
  if (!violation.vertices.empty()) {
    return fmt::format("edge {}-{}: ", soup.vertex_ids.of(violation.vertices[0]),
                       soup.vertex_ids.of(violation.vertices[1]));
  }
  return violation.faces.empty() ? ""
                                 : fmt::format("face {}: ", soup.face_ids.of(violation.faces[0]));
}

Finding finding_of(const LimitViolation& violation, const LimitInfo& info, double limit,
                   const Soup& soup) {
  Finding finding{
      .code = info.name,
      .severity = Severity::Error,
      .message = fmt::format("{}{} {:.6g}{}, {} {:.6g}", subject_of(violation, soup), info.quantity,
                             violation.value + 0.0, info.unit,
                             info.sense == LimitSense::AtLeast ? "below" : "above", limit),
      .fix = "",
      .line = std::nullopt,
      .vertices = first_ids(violation.vertices, soup.vertex_ids),
      .faces = first_ids(violation.faces, soup.face_ids),
      .position = violation.position,
      .value = violation.value,
      .limit = limit};
  if (!violation.vertices.empty()) {
    finding.line = record_line(soup.vertex_lines, violation.vertices[0]);
  } else if (!violation.faces.empty()) {
    finding.line = record_line(soup.face_lines, violation.faces[0]);
  }
  return finding;
}

/// Collects the findings about one mesh.
class FileFindingsBuilder {
 public:
  FileFindingsBuilder(const PreparedMesh& mesh, const CheckCriteria& criteria, FileFindings& file)
      : mesh_(mesh), criteria_(criteria), file_(file) {}

  /// @param report  The report, which must list all defects.
  void add_defects(const DefectReport& report, Severity severity) {
    const DefectList& defects = report.defects;
    std::size_t end = 0;
    for (const DefectCode code : all_defect_codes()) {
      const std::size_t begin = end;
      end += report.count(code);
      if (begin == end || catalogue_entry(code).severity != severity) continue;
      FindingCount& found = count(defect_name(code), severity, report.count(code));
      found.is_at_least = report.unfinished.contains(code);
      for (std::size_t i = begin; i < end; ++i) found.fixable += defects.is_fixable(i) ? 1 : 0;
      for (std::size_t i = begin; i < begin + n_listed(report.count(code)); ++i) {
        file_.findings.push_back(finding_of(defects[i], mesh_.soup(), found.is_at_least));
      }
    }
  }

  void add_beyond_limits() {
    for (const LimitInfo& info : limit_table()) {
      const std::optional<double>& limit = criteria_.limits[info.kind];
      if (!limit) continue;
      const std::vector<LimitViolation> found = find_beyond_limit(mesh_, info.kind, *limit);
      if (found.empty()) continue;
      count(info.name, Severity::Error, found.size());
      for (std::size_t i = 0; i < n_listed(found.size()); ++i) {
        file_.findings.push_back(finding_of(found[i], info, *limit, mesh_.soup()));
      }
    }
  }

 private:
  FindingCount& count(std::string_view code, Severity severity, std::size_t n) {
    return file_.counts.emplace_back(FindingCount{.code = code, .severity = severity, .count = n});
  }

  [[nodiscard]] std::size_t n_listed(std::size_t n) const {
    return criteria_.max_listed == 0 ? n : std::min(n, criteria_.max_listed);
  }

  const PreparedMesh& mesh_;
  const CheckCriteria& criteria_;
  FileFindings& file_;
};

}  // namespace

FileFindings check_mesh(Soup soup, std::string path, const CheckCriteria& criteria) {
  PreparedMesh mesh(std::make_shared<const Soup>(std::move(soup)),
                    {.max_found = criteria.max_pairs, .wants_to_stop = {}});
  FileFindings file;
  file.path = std::move(path);
  file.format = mesh.soup().format;
  file.vertices = mesh.soup().n_vertices();
  file.faces = mesh.soup().n_faces();
  const DefectReport report =
      find_defects(mesh, {.codes = criteria.codes, .tolerances = criteria.tolerances});
  FileFindingsBuilder findings(mesh, criteria, file);
  findings.add_defects(report, Severity::Error);
  if (has_finite_positions(mesh.soup())) findings.add_beyond_limits();
  findings.add_defects(report, Severity::Warning);
  cut_listed(file, criteria.max_listed, criteria.max_lines);
  return file;
}

}  // namespace meshalyzer
