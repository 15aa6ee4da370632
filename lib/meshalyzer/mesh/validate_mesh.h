#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// A list of sentences about faults; those beyond the limit are dropped.
class Complaints {
 public:
  explicit Complaints(std::size_t max) : max_(max) {}
  void add(std::string sentence) {
    none_ = false;
    if (sentences_.size() < max_) sentences_.push_back(std::move(sentence));
  }
  [[nodiscard]] bool none() const { return none_; }
  [[nodiscard]] std::vector<std::string> sentences() && { return std::move(sentences_); }

 private:
  std::size_t max_;
  bool none_ = true;
  std::vector<std::string> sentences_;
};

/// Checks the invariants of a half-edge mesh of triangles that validate() lists.
///
/// It is safe on any content: handles out of range are reported, and the check then ends.
///
/// @complexity O(#V + #H).
void validate_mesh(const TriMesh& mesh, Complaints& complaints);

}  // namespace meshalyzer
