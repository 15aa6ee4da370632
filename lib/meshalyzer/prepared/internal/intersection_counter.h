#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/prepared/intersection_counts.h"
#include "meshalyzer/spatial/pair_listener.h"
#include "meshalyzer/topology/components.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace meshalyzer {

/// Counts intersecting pairs while a search finds them.
class IntersectionCounter : public PairListener {
 public:
  /// The data of the components that the counter needs. It only refers to them.
  struct Parts {
    const SideTable& side;
    const Components& components;
    /// #components: non-zero for shells.
    std::span<const std::uint8_t> is_shell;
    std::span<const Box3> boxes;
  };

  explicit IntersectionCounter(const Parts& parts);

  void on_pairs(std::span<const IntersectingPair> pairs) override;
  /// @complexity O(n log n) in the number of faces of the product, whatever the number of pairs.
  void on_product(const PairProduct& product) override;

  /// Returns the counts; the counter must not be used again.
  [[nodiscard]] IntersectionCounts take();

 private:
  [[nodiscard]] Index meet(Index file_face);
  [[nodiscard]] bool may_enclose(Index outer, Index inner) const;
  void append_contact(Index a, Index b, ContactKind kind, std::vector<PartContact>& contacts) const;
  void count_by_component(const PairProduct& product, std::span<const Index> a,
                          std::span<const Index> b);
  [[nodiscard]] std::vector<Index> meet(std::span<const Index> file_faces);
  [[nodiscard]] std::vector<PartContact> contacts_between(std::span<const Index> a,
                                                          std::span<const Index> b,
                                                          ContactKind kind) const;
  void add_contacts(std::span<const PartContact> contacts);

  const Parts parts_;
  std::mutex mutex_;
  IntersectionCounts counts_;
  /// Contacts are merged when they reach this number.
  std::size_t enough_contacts_;
};

}  // namespace meshalyzer
