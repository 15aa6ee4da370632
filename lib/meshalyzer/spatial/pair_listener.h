#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// All pairs of a face of one list and a face of another, which have one kind of contact.
struct PairProduct {
  /// File faces, ascending. The same list twice: all pairs of different faces in it.
  std::span<const Index> a;
  std::span<const Index> b;
  ContactKind kind = ContactKind::Touching;

  [[nodiscard]] bool is_within_one() const { return a.data() == b.data(); }
  [[nodiscard]] std::size_t n_pairs() const {
    return is_within_one() ? a.size() * (a.size() - 1) / 2 : a.size() * b.size();
  }
};

/// Takes the pairs that a search finds: in no particular order, and from several threads at once.
class PairListener {
 public:
  PairListener() = default;
  PairListener(const PairListener&) = delete;
  PairListener& operator=(const PairListener&) = delete;
  virtual ~PairListener() = default;

  /// Takes some pairs; each pair comes once.
  virtual void on_pairs(std::span<const IntersectingPair> pairs) = 0;
  virtual void on_product(const PairProduct& product) = 0;
};

}  // namespace meshalyzer
