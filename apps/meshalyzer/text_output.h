#pragma once

#include "output.h"
#include "run.h"

#include <cstddef>
#include <iosfwd>

namespace meshalyzer {

/// The report as text: each mesh as it is done, and of a set what there is to say of it.
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

/// Writes what a report says about a set as a whole, which comes after what it says about its
/// meshes. A set without meshes has no such part.
void tell_set(const SetAnalysis* set, const Run& run, std::ostream& out);

}  // namespace meshalyzer
