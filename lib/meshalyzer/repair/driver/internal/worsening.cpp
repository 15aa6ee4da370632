#include "meshalyzer/repair/driver/internal/worsening.h"

#include <algorithm>
#include <iterator>

namespace meshalyzer {
namespace {

using enum CountedDefect;

/// Returns by how much a number has become greater.
std::size_t increase(std::size_t before, std::size_t after) {
  return after - std::min(before, after);
}

std::size_t fall_of(CountedDefect kind, const DefectInventory& before,
                    const DefectInventory& after) {
  return increase(after.count(kind), before.count(kind));
}

/// Returns the permitted increase of a count.
std::size_t allowed_rise(CountedDefect kind, const DefectInventory& before,
                         const DefectInventory& after) {
  const bool is_left_by_parting = kind == BorderEdges || kind == PinchedVertices;
  std::size_t allowed = is_left_by_parting ? fall_of(NonManifoldEdges, before, after) : 0;
  if (fall_of(IntersectingPairs, before, after) == 0) return allowed;
  if (kind == BorderEdges) {
    allowed += increase(before.n_borders_of_cut_sheets, after.n_borders_of_cut_sheets);
  }
  if (kind == SlitEdges) {
    allowed += increase(before.n_slits_of_cut_sheets, after.n_slits_of_cut_sheets);
  }
  return allowed;
}

/// Returns the kinds of elements that a mesh with an attribute has none of.
std::vector<CountedDefect> kinds_against(Attribute attribute) {
  switch (attribute) {
    case Attribute::Closed:
      return {BorderEdges};
    case Attribute::Manifold:
      return {NonManifoldEdges, NonManifoldVertices};
    case Attribute::Consistent:
      return {FlippedEdges};
    case Attribute::Orientable:
    case Attribute::Outward:
      break;
  }
  return {};
}

std::vector<CountedElement> elements_of(const DefectInventory& inventory, CountedDefect kind) {
  std::vector<CountedElement> elements;
  std::copy_if(inventory.elements.begin(), inventory.elements.end(), std::back_inserter(elements),
               [&](const CountedElement& element) { return element.kind == kind; });
  return elements;
}

/// Returns the elements that are in the first list more often than in the second.
std::vector<CountedElement> without(const std::vector<CountedElement>& elements,
                                    const std::vector<CountedElement>& others) {
  std::vector<CountedElement> rest;
  std::set_difference(elements.begin(), elements.end(), others.begin(), others.end(),
                      std::back_inserter(rest));
  return rest;
}

/// Removes the border edges that a non-manifold edge has become, unless nothing would be left.
void prefer_other_than_parted(const DefectInventory& before, std::vector<CountedElement>& borders) {
  std::vector<CountedElement> parted = elements_of(before, NonManifoldEdges);
  for (CountedElement& edge : parted) edge.kind = BorderEdges;
  std::vector<CountedElement> others = without(borders, parted);
  if (!others.empty()) borders = std::move(others);
}

}  // namespace

std::vector<CountRise> find_rises(const DefectInventory& before, const DefectInventory& after) {
  std::vector<CountRise> rises;
  for (std::size_t k = 0; k < kCountedDefects; ++k) {
    if (after.counts[k] > before.counts[k]) {
      rises.push_back({static_cast<CountedDefect>(k), before.counts[k], after.counts[k]});
    }
  }
  return rises;
}

Worsening find_worsening(const DefectInventory& before, const DefectInventory& after) {
  Worsening worsening;
  for (const CountRise& rise : find_rises(before, after)) {
    if (rise.after - rise.before > allowed_rise(rise.kind, before, after)) {
      worsening.kinds.push_back(rise.kind);
    }
  }
  for (std::size_t a = 0; a < kAttributes; ++a) {
    if (!before.is_yes[a] || after.is_yes[a]) continue;
    worsening.lost.push_back(static_cast<Attribute>(a));
    for (const CountedDefect kind : kinds_against(worsening.lost.back())) {
      if (after.count(kind) != 0) worsening.kinds.push_back(kind);
    }
  }
  return worsening;
}

std::vector<CountedElement> find_new_elements(const DefectInventory& before,
                                              const DefectInventory& after,
                                              const Worsening& worsening) {
  std::vector<CountedElement> found;
  for (const CountedDefect kind : worsening.kinds) {
    std::vector<CountedElement> added =
        without(elements_of(after, kind), elements_of(before, kind));
    if (kind == BorderEdges) prefer_other_than_parted(before, added);
    found.insert(found.end(), added.begin(), added.end());
  }
  return found;
}

}  // namespace meshalyzer
