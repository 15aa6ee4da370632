#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/object_findings.h"
#include "meshalyzer/set/set_analysis.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Tells whether the JSON report lists the offending elements.
enum class JsonOffenders { Omit, List };

/// Receives the pieces of a text, one after the other.
using TextSink = std::function<void(std::string_view)>;

/// Writes the JSON report (doc/report.schema.json) piece by piece, so that a set of any size needs
/// no more memory than one mesh.
///
/// First all meshes and unreadable files are added, then all findings between the meshes, then the
/// report is finished: any other order throws InvalidArgument. Exceptions of the sink pass through;
/// the report is then lost.
class JsonReport {
 public:
  /// @throws InvalidArgument  if the sink is null.
  JsonReport(TextSink sink, JsonOffenders offenders);
  ~JsonReport();
  JsonReport(JsonReport&&) noexcept;
  JsonReport& operator=(JsonReport&&) noexcept;

  /// Adds an element of "meshes".
  void add(const Analysis& mesh);

  /// Adds an element of "unreadable".
  /// @param why  The reason in words.
  void add_unreadable(std::string path, std::string why);

  /// Adds the rows of "closest" of one mesh of a set, if its separation was requested; finish()
  /// writes the intersections.
  /// @param names  The names of the meshes of the set, by number.
  void add(const ObjectFindings& findings, const std::vector<std::string>& names);

  /// @param set  The findings about the set, or null: then the report has no "set".
  void finish(const SetAnalysis* set);

 private:
  class Pieces;
  std::unique_ptr<Pieces> pieces_;
};

/// Returns the report as JSON (doc/report.schema.json), all at once; see JsonReport.
///
/// @param set  The findings about the set, or null: then the report has no "set". Its "closest" is
///             null.
[[nodiscard]] std::string json_report(std::span<const Analysis> meshes, const SetAnalysis* set,
                                      JsonOffenders offenders);

}  // namespace meshalyzer
