#pragma once

#include "output.h"
#include "run.h"

#include <cstddef>
#include <iosfwd>

namespace meshalyzer {

/// Writes a table with one line for each mesh (--summary), and the findings about a set.
class SummaryOutput : public Output {
 public:
  SummaryOutput(const Run& run, std::ostream& out);

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void finish(const SetAnalysis* set) override;

 private:
  const Run& run_;
  std::ostream& out_;
  /// The width of the first column.
  std::size_t name_width_;
};

}  // namespace meshalyzer
