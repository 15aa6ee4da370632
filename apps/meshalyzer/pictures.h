#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/html/index_page.h"
#include "output.h"
#include "picture_paths.h"
#include "run.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Tells whether any pictures are requested.
[[nodiscard]] bool draws_pictures(const Options& options);

/// Tells whether the meshes of a run are drawn as soon as they are analysed, so that the prepared
/// meshes should be kept until then (SetOptions::keep_mesh).
[[nodiscard]] bool draws_at_once(const Run& run);

/// Writes the pictures of a run as its findings come: a page for each mesh and their index
/// (--html), a field (--export), the separation (--separation-ply).
class Pictures : public Output {
 public:
  explicit Pictures(const Run& run);

  // The following functions throw IoError if a file cannot be read again, or written.

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void on_findings(const ObjectFindings& findings) override;
  void finish(const SetAnalysis* set) override;

 private:
  /// A mesh whose separation is not known yet.
  struct Waiting {
    /// The analysis without the file and the offenders.
    Analysis analysis;
    std::optional<std::vector<IntersectingPair>> pairs;
  };

  void wait(Index number, const Analysis& mesh);
  void read_and_draw(Index number, const Waiting& waiting, const ObjectSeparation* separation);
  void draw(Index number, const Analysis& analysis, const PreparedMesh& mesh,
            const ObjectSeparation* separation);
  void write_page(Index number, const Analysis& analysis, const FieldSource& source);
  [[nodiscard]] bool draws_meshes() const;

  const Run& run_;
  const PicturePaths& paths_;
  /// The waiting meshes by number: they are drawn in this order.
  std::map<Index, Waiting> waiting_;
  std::vector<IndexRow> rows_;
};

}  // namespace meshalyzer
