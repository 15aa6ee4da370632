#pragma once

#include "meshalyzer/repair/driver/internal/repair_state.h"
#include "meshalyzer/repair/edits/internal/affected_elements.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {

// Private to check_acceptance().

/// Two intersecting faces, by key.
struct ContactByKey {
  Index face_a = kNoIndex;
  Index face_b = kNoIndex;
  ContactKind kind = ContactKind::Touching;
};

/// @param pairs  Of the state's mesh.
[[nodiscard]] std::vector<ContactByKey> contacts_by_key(const RepairState& state,
                                                        const std::vector<IntersectingPair>& pairs);

/// The contacts of a mesh before a change, by face and by operation.
class PriorContacts {
 public:
  /// @param affected  Must outlive this.
  PriorContacts(const RepairState& before, const AffectedElements& affected);

  /// Tells whether both faces were in contact, of any kind.
  [[nodiscard]] bool were_in_contact(const ContactByKey& contact) const;

  /// Tells whether the faces of an operation were in contact with a face, of this kind or a worse
  /// one. All faces that an operation affects count as one here: if a face is flipped, split or
  /// removed, its neighbours inherit its contacts.
  ///
  /// @param face  A key of the mesh after the change.
  [[nodiscard]] bool was_in_contact(Index operation, Index face, ContactKind kind) const;

 private:
  /// A partner in a contact: one face, or all faces that an operation affects.
  struct Partner {
    enum class Kind : std::uint8_t { Face, Operation };
    Kind kind = Kind::Face;
    Index number = kNoIndex;
    friend auto operator<=>(const Partner&, const Partner&) = default;
  };
  struct PriorContact {
    Index operation = kNoIndex;
    Partner other;
    std::uint8_t severity = 0;
    friend auto operator<=>(const PriorContact&, const PriorContact&) = default;
  };

  [[nodiscard]] static std::vector<Partner> partners_of(
      Index face, const std::vector<AffectedElement>& entries);
  void add(Index face, Index other, ContactKind kind);

  const AffectedElements& affected_;
  /// Pairs of face keys with the smaller first, in ascending order.
  std::vector<std::pair<Index, Index>> pairs_;
  /// Ascending.
  std::vector<PriorContact> contacts_;
};

}  // namespace meshalyzer
