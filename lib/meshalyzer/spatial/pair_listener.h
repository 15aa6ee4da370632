#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// All pairs of a face of one list and a face of another; all have the same kind of contact.
struct PairProduct {
  /// The file faces, ascending. If both are the same list, its pairs of different faces are meant.
  std::span<const Index> a;
  std::span<const Index> b;
  ContactKind kind = ContactKind::Touching;

  [[nodiscard]] bool is_within_one() const { return a.data() == b.data(); }
  [[nodiscard]] std::size_t n_pairs() const {
    return is_within_one() ? a.size() * (a.size() - 1) / 2 : a.size() * b.size();
  }
};

/// Receives the pairs that a search finds, in no particular order and from several threads at once.
class PairListener {
 public:
  PairListener() = default;
  PairListener(const PairListener&) = delete;
  PairListener& operator=(const PairListener&) = delete;
  virtual ~PairListener() = default;

  /// Receives some pairs; each pair comes once.
  virtual void on_pairs(std::span<const IntersectingPair> pairs) = 0;
  virtual void on_product(const PairProduct& product) = 0;
};

}  // namespace meshalyzer
