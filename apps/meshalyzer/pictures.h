#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/html/page.h"
#include "meshalyzer/set/object_findings.h"
#include "meshalyzer/set/set_analysis.h"
#include "options.h"
#include "picture_paths.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// What a run is of, for its pictures. Only referred to.
struct PictureSubject {
  const Options& options;
  /// The mesh files.
  const std::vector<std::string>& files;
  /// What the meshes are called in the report.
  const std::vector<std::string>& names;
  PicturePaths paths;
  enum class Separation { Never, Follows };
  /// Whether the pictures of a mesh wait for its distances to others.
  Separation separation = Separation::Never;
};

/// Writes the pictures of a run as its findings come: a page a mesh and their index (--html), a
/// field (--export), the separation (--separation-ply).
class Pictures {
 public:
  explicit Pictures(PictureSubject subject);

  // What follows throws IoError where a file cannot be read again, or written.

  void on_mesh(Index number, const Analysis& mesh);
  void on_unreadable(Index number, const std::string& why);
  void on_findings(const ObjectFindings& findings);
  /// @param set  Null where there is none to tell of.
  void finish(const SetAnalysis* set);

 private:
  /// A mesh whose distances to others are not known yet.
  struct Waiting {
    /// Without the file and the offenders.
    Analysis analysis;
    std::optional<std::vector<IntersectingPair>> pairs;
  };

  void draw(Index number, const Waiting& mesh, const Soup& soup,
            const ObjectSeparation* separation);
  void write_page(Index number, const Waiting& mesh, const FieldSource& source);
  [[nodiscard]] bool draws_meshes() const;

  PictureSubject subject_;
  /// By number, in order: what waits is drawn in the same order whatever came first.
  std::map<Index, Waiting> waiting_;
  std::vector<IndexRow> rows_;
};

}  // namespace meshalyzer
