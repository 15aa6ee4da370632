#include "meshalyzer/prepared/internal/intersection_counter.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/tally.h"

#include <algorithm>
#include <atomic>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// Merging does not pay with fewer contacts.
constexpr std::size_t kFewContacts = std::size_t{1} << 16;

/// Merges the contacts of each pair of components, ascending; the pair crosses if any contact does.
void merge_contacts(std::vector<PartContact>& contacts) {
  const auto key = [](const PartContact& c) { return std::tuple(c.a, c.b, !c.crosses); };
  std::sort(contacts.begin(), contacts.end(),
            [&](const PartContact& x, const PartContact& y) { return key(x) < key(y); });
  const auto same_parts = [](const PartContact& x, const PartContact& y) {
    return x.a == y.a && x.b == y.b;
  };
  contacts.erase(std::unique(contacts.begin(), contacts.end(), same_parts), contacts.end());
}

}  // namespace

IntersectionCounter::IntersectionCounter(const Parts& parts)
    : parts_(parts), enough_contacts_(kFewContacts) {
  counts_.intersects.resize(parts.side.faces.size(), 0);
  counts_.of_component.resize(parts.components.count, 0);
}

void IntersectionCounter::on_pairs(std::span<const IntersectingPair> pairs) {
  ContactCounts kinds;
  kinds.add(pairs);
  std::vector<PartContact> contacts;
  const auto count_of = [&](Index c) -> std::size_t& { return counts_.of_component[c]; };
  Tally tally_a(count_of);
  Tally tally_b(count_of);
  for (const IntersectingPair& pair : pairs) {
    const Index a = meet(pair.face_a);
    const Index b = meet(pair.face_b);
    tally_a.add(a);
    if (a == b) continue;
    tally_b.add(b);
    append_contact(a, b, pair.kind, contacts);
  }
  const std::lock_guard lock(mutex_);
  counts_.kinds.add(kinds);
  add_contacts(contacts);
}

void IntersectionCounter::on_product(const PairProduct& product) {
  std::vector<Index> a = meet(product.a);
  std::vector<Index> b = product.is_within_one() ? a : meet(product.b);
  count_by_component(product, a, b);
  sort_unique(a);
  sort_unique(b);
  const std::vector<PartContact> contacts = contacts_between(a, b, product.kind);
  const std::lock_guard lock(mutex_);
  counts_.kinds.add(product.kind, product.n_pairs());
  add_contacts(contacts);
}

/// @param a  The components of the faces of product.a, ascending; b likewise.
void IntersectionCounter::count_by_component(const PairProduct& product, std::span<const Index> a,
                                             std::span<const Index> b) {
  const auto n_within = [](std::size_t n) { return n * (n - 1) / 2; };
  const auto n_with = [&](Index component) {
    const auto [first_a, last_a] = std::equal_range(a.begin(), a.end(), component);
    const auto [first_b, last_b] = std::equal_range(b.begin(), b.end(), component);
    const std::size_t others_a = a.size() - static_cast<std::size_t>(last_a - first_a);
    const std::size_t others_b = b.size() - static_cast<std::size_t>(last_b - first_b);
    return product.n_pairs() - (product.is_within_one() ? n_within(others_a) : others_a * others_b);
  };
  std::vector<Index> components(a.begin(), a.end());
  components.insert(components.end(), b.begin(), b.end());
  sort_unique(components);
  for (const Index component : components) {
    std::atomic_ref(counts_.of_component[component])
        .fetch_add(n_with(component), std::memory_order_relaxed);
  }
}

/// Returns the contacts of each component of one list with each of the other. Represented faces
/// belong to no shell, so that one of the lists is short if the other has shells.
std::vector<PartContact> IntersectionCounter::contacts_between(std::span<const Index> a,
                                                               std::span<const Index> b,
                                                               ContactKind kind) const {
  const auto has_shell = [&](std::span<const Index> list) {
    return std::any_of(list.begin(), list.end(), [&](Index c) { return parts_.is_shell[c] != 0; });
  };
  std::vector<PartContact> contacts;
  if (!has_shell(a) && !has_shell(b)) return contacts;
  for (const Index first : a) {
    for (const Index second : b) {
      if (first != second) append_contact(first, second, kind, contacts);
    }
  }
  return contacts;
}

/// Marks faces as intersecting, and returns the component of each, ascending.
std::vector<Index> IntersectionCounter::meet(std::span<const Index> file_faces) {
  std::vector<Index> components;
  components.reserve(file_faces.size());
  for (const Index face : file_faces) components.push_back(meet(face));
  std::sort(components.begin(), components.end());
  return components;
}

/// Marks a face as intersecting, and returns its component.
Index IntersectionCounter::meet(Index file_face) {
  const std::size_t face = parts_.side.mesh_face(file_face);
  std::atomic_ref(counts_.intersects[face]).store(1, std::memory_order_relaxed);
  return parts_.components.of_face[face];
}

/// Appends a contact of two components if one may enclose the other: only then is it relevant to
/// the nesting.
void IntersectionCounter::append_contact(Index a, Index b, ContactKind kind,
                                         std::vector<PartContact>& contacts) const {
  if (!may_enclose(a, b) && !may_enclose(b, a)) return;
  contacts.push_back({std::min(a, b), std::max(a, b), kind == ContactKind::Crossing});
}

/// Tells whether a component is a shell whose box contains another component.
bool IntersectionCounter::may_enclose(Index outer, Index inner) const {
  return parts_.is_shell[outer] != 0 && parts_.boxes[outer].contains(parts_.boxes[inner]);
}

void IntersectionCounter::add_contacts(std::span<const PartContact> contacts) {
  counts_.contacts.insert(counts_.contacts.end(), contacts.begin(), contacts.end());
  // Contacts are merged now and then, so that memory grows with the pairs of components, not with
  // those of faces.
  if (counts_.contacts.size() >= enough_contacts_) {
    merge_contacts(counts_.contacts);
    enough_contacts_ = std::max(kFewContacts, 2 * counts_.contacts.size());
  }
}

IntersectionCounts IntersectionCounter::take() {
  merge_contacts(counts_.contacts);
  return std::move(counts_);
}

}  // namespace meshalyzer
