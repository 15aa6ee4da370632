#pragma once

#include "output.h"
#include "run.h"

#include <cstddef>
#include <iosfwd>

namespace meshalyzer {

/// A table with a line a mesh (--summary), and of a set what there is to say of it.
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
