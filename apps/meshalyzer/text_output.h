#pragma once

#include "output.h"
#include "run.h"

#include <cstddef>
#include <iosfwd>

namespace meshalyzer {

/// Writes the report as text: each mesh when it is done, and the findings about a set.
class TextOutput : public Output {
 public:
  TextOutput(const Run& run, std::ostream& out) : run_(run), out_(out) {}

  void on_mesh(Index number, const Analysis& mesh) override;
  void finish(const SetAnalysis* set) override;

 private:
  const Run& run_;
  std::ostream& out_;
  std::size_t n_told_ = 0;
};

/// Writes the part of a report about the set as a whole, which follows the meshes. A set without
/// meshes has no such part.
void tell_set(const SetAnalysis* set, const Run& run, std::ostream& out);

}  // namespace meshalyzer
