#pragma once

#include "meshalyzer/repair/edits/touched.h"
#include "meshalyzer/repair/trial/repair_state.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {

// Private to judge_trial(): which faces had to do with each other before a change.

/// Two intersecting faces, by key.
struct ContactByKey {
  Index face_a = kNoIndex;
  Index face_b = kNoIndex;
  ContactKind kind = ContactKind::Touching;
};

/// @param pairs  Of the state's mesh.
[[nodiscard]] std::vector<ContactByKey> contacts_by_key(const RepairState& state,
                                                        const std::vector<IntersectingPair>& pairs);

/// The contacts of a mesh before a change, face by face and operation by operation.
class KnownContacts {
 public:
  /// @param touched  Must outlive this.
  KnownContacts(const RepairState& before, const Touched& touched);

  /// Whether both faces met, in whatever way.
  [[nodiscard]] bool have_met(const ContactByKey& contact) const;

  /// Whether an operation's faces met a face, in the way that is given or a worse one. Faces that
  /// an operation touches are one in this: where a face is flipped, split or taken away, its
  /// neighbours inherit what it met.
  ///
  /// @param face  Of the mesh after the change.
  [[nodiscard]] bool has_met(Index operation, Index face, ContactKind kind) const;

 private:
  /// One face, or all those that an operation touches.
  struct Site {
    enum class Kind : std::uint8_t { Face, Operation };
    Kind kind = Kind::Face;
    Index number = kNoIndex;
    friend auto operator<=>(const Site&, const Site&) = default;
  };
  struct Meeting {
    Index operation = kNoIndex;
    Site other;
    std::uint8_t badness = 0;
    friend auto operator<=>(const Meeting&, const Meeting&) = default;
  };

  [[nodiscard]] static std::vector<Site> sites_of(Index face, const std::vector<Touch>& touches);
  void add(Index face, Index other, ContactKind kind);

  const Touched& touched_;
  /// By key, the smaller first; ascending.
  std::vector<std::pair<Index, Index>> pairs_;
  /// Ascending.
  std::vector<Meeting> meetings_;
};

}  // namespace meshalyzer
