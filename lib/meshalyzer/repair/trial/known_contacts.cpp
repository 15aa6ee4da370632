#include "meshalyzer/repair/trial/known_contacts.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// Welding takes contact along seams away; where surfaces overlap or pass through each other they
/// touch, too.
std::uint8_t badness_of(ContactKind kind) {
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
  const std::vector<Index>& keys = state.draft().face_keys;
  for (const IntersectingPair& pair : pairs) {
    contacts.push_back({keys[pair.face_a], keys[pair.face_b], pair.kind});
  }
  return contacts;
}

KnownContacts::KnownContacts(const RepairState& before, const Touched& touched)
    : touched_(touched) {
  for (const ContactByKey& contact : contacts_by_key(before, before.mesh().intersecting_pairs())) {
    pairs_.emplace_back(std::minmax(contact.face_a, contact.face_b));
    add(contact.face_a, contact.face_b, contact.kind);
    add(contact.face_b, contact.face_a, contact.kind);
  }
  std::sort(pairs_.begin(), pairs_.end());
  std::sort(meetings_.begin(), meetings_.end());
}

bool KnownContacts::have_met(const ContactByKey& contact) const {
  const std::pair<Index, Index> keys = std::minmax(contact.face_a, contact.face_b);
  return std::binary_search(pairs_.begin(), pairs_.end(), keys);
}

bool KnownContacts::has_met(Index operation, Index face, ContactKind kind) const {
  const std::vector<Site> sites = sites_of(face, touched_.faces_after);
  return std::any_of(sites.begin(), sites.end(), [&](const Site& other) {
    const auto found = std::lower_bound(meetings_.begin(), meetings_.end(),
                                        Meeting{operation, other, badness_of(kind)});
    return found != meetings_.end() && found->operation == operation && found->other == other;
  });
}

std::vector<KnownContacts::Site> KnownContacts::sites_of(Index face,
                                                         const std::vector<Touch>& touches) {
  std::vector<Site> sites;
  for (const Touch& touch : touching(touches, face)) {
    sites.push_back({Site::Kind::Operation, touch.operation});
  }
  if (sites.empty()) sites.push_back({Site::Kind::Face, face});
  return sites;
}

void KnownContacts::add(Index face, Index other, ContactKind kind) {
  for (const Touch& touch : touching(touched_.faces_before, face)) {
    for (const Site& site : sites_of(other, touched_.faces_before)) {
      meetings_.push_back({touch.operation, site, badness_of(kind)});
    }
  }
}

}  // namespace meshalyzer
