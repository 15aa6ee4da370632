#include "meshalyzer/repair/driver/internal/prior_contacts.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// Orders kinds of contact by gravity: welding removes contact along seams, and surfaces that
/// overlap or cross each other also touch.
std::uint8_t severity_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::Unwelded:
      return 0;
    case ContactKind::Touching:
      return 1;
    case ContactKind::Duplicate:
    case ContactKind::FoldOver:
    case ContactKind::CoplanarOverlap:
      return 2;
    case ContactKind::Crossing:
      return 3;
  }
  return 0;
}

}  // namespace

std::vector<ContactByKey> contacts_by_key(const RepairState& state,
                                          const std::vector<IntersectingPair>& pairs) {
  std::vector<ContactByKey> contacts;
  contacts.reserve(pairs.size());
  const std::vector<Index>& keys = state.tracked().face_keys;
  for (const IntersectingPair& pair : pairs) {
    contacts.push_back({keys[pair.face_a], keys[pair.face_b], pair.kind});
  }
  return contacts;
}

PriorContacts::PriorContacts(const RepairState& before, const AffectedElements& affected)
    : affected_(affected) {
  for (const ContactByKey& contact : contacts_by_key(before, before.mesh().intersecting_pairs())) {
    const bool is_affected = !operations_on(affected.faces_before, contact.face_a).empty() ||
                             !operations_on(affected.faces_before, contact.face_b).empty();
    // Pairs of two other faces are the same after the change.
    if (!is_affected) continue;
    pairs_.emplace_back(std::minmax(contact.face_a, contact.face_b));
    add(contact.face_a, contact.face_b, contact.kind);
    add(contact.face_b, contact.face_a, contact.kind);
  }
  std::sort(pairs_.begin(), pairs_.end());
  std::sort(contacts_.begin(), contacts_.end());
}

bool PriorContacts::were_in_contact(const ContactByKey& contact) const {
  const std::pair<Index, Index> keys = std::minmax(contact.face_a, contact.face_b);
  return std::binary_search(pairs_.begin(), pairs_.end(), keys);
}

bool PriorContacts::was_in_contact(Index operation, Index face, ContactKind kind) const {
  const std::vector<Partner> partners = partners_of(face, affected_.faces_after);
  return std::any_of(partners.begin(), partners.end(), [&](const Partner& other) {
    const auto found = std::lower_bound(contacts_.begin(), contacts_.end(),
                                        PriorContact{operation, other, severity_of(kind)});
    return found != contacts_.end() && found->operation == operation && found->other == other;
  });
}

std::vector<PriorContacts::Partner> PriorContacts::partners_of(
    Index face, const std::vector<AffectedElement>& entries) {
  std::vector<Partner> partners;
  for (const AffectedElement& entry : operations_on(entries, face)) {
    partners.push_back({Partner::Kind::Operation, entry.operation});
  }
  if (partners.empty()) partners.push_back({Partner::Kind::Face, face});
  return partners;
}

void PriorContacts::add(Index face, Index other, ContactKind kind) {
  for (const AffectedElement& entry : operations_on(affected_.faces_before, face)) {
    for (const Partner& partner : partners_of(other, affected_.faces_before)) {
      contacts_.push_back({entry.operation, partner, severity_of(kind)});
    }
  }
}

}  // namespace meshalyzer
