#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/internal/pass_memory.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/split/internal/check_budget.h"
#include "meshalyzer/repair/split/internal/contact_places.h"
#include "meshalyzer/repair/split/internal/moved_faces.h"
#include "meshalyzer/repair/split/internal/parting_directions.h"
#include "meshalyzer/repair/split/internal/parting_memory.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The factors between successive steps: a small one for directions that were chosen well, a large
/// one for others.
constexpr double kFineGrowth = 2.0;
constexpr double kCoarseGrowth = 16.0;
/// Neighbours are looked up within this multiple of the step.
constexpr double kLookupReach = 256.0;
/// The maximum number of touching units at a place that are compared; the one that needs the
/// smallest step is moved.
constexpr std::size_t kUnitsAtOnce = 4;
/// If at most this fraction of the places could not be parted, they are tried once more, first.
constexpr double kShareTriedAgain = 0.1;

/// Tells whether vertices that were moved at other places may have taken away the room at those
/// that could not be parted.
bool may_be_in_the_way(std::size_t n_failed, std::size_t n_places) {
  return n_failed > 0 &&
         static_cast<double>(n_failed) <= kShareTriedAgain * static_cast<double>(n_places);
}

/// Sets of places that have a face in common: an edge touches until both its ends have moved.
DisjointSets connect_places(const ContactPlaces& contacts) {
  std::vector<std::pair<Index, Index>> place_of_face;
  for (Index i = 0; i < contacts.places.size(); ++i) {
    for (const auto& unit : contacts.places[i].units) {
      for (const Index v : unit) {
        for (const Index face : contacts.incident.faces(contacts.incident.entry_of(v))) {
          place_of_face.emplace_back(face, i);
        }
      }
    }
  }
  std::sort(place_of_face.begin(), place_of_face.end());
  DisjointSets connected(contacts.places.size());
  for (std::size_t i = 1; i < place_of_face.size(); ++i) {
    if (place_of_face[i].first == place_of_face[i - 1].first) {
      connected.unite(place_of_face[i].second, place_of_face[i - 1].second);
    }
  }
  return connected;
}

/// Moves vertices place by place, each in the mesh that the moves before it have left.
class Parting {
 public:
  Parting(const PassInput& input, const ContactPlaces& contacts)
      : input_(input), contacts_(contacts), mesh_(input.mesh) {
    const Box3& bounds = input.mesh.tree().bounds();
    const double size =
        std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    first_step_ =
        std::max(size * std::numeric_limits<double>::epsilon(), std::numeric_limits<double>::min());
    if (input.memory != nullptr) {
      memory_.emplace(input.memory->failed_partings, input.tracked, mesh_, first_step_);
      for (const ContactPlace& place : contacts.places) keys_.push_back(memory_->key_of(place));
    }
  }

  /// Parts all places.
  ///
  /// @param first  Places that come before all others.
  [[nodiscard]] PassResult part_all(std::span<const Index> first) {
    DisjointSets connected = connect_places(contacts_);
    std::vector<Index> operation(contacts_.places.size(), kNoIndex);
    CheckBudget budget(n_moves());
    for (const Index i : places_in_order(first)) {
      if (input_.wants_to_stop()) break;
      n_checks_left_ = budget.of_next_place();
      const std::vector<Index> moved = part_unless_known(i);
      budget.spend(budget.of_next_place() - n_checks_left_);
      if (moved.empty()) continue;
      Index& op = operation[connected.find(i)];
      if (op == kNoIndex) op = result_.edits.begin_operation();
      for (const Index v : moved) {
        result_.edits.moved_vertices.push_back({.op = op, .vertex = v, .to = mesh_.position(v)});
      }
    }
    return std::move(result_);
  }

  /// Returns the places where not all could be parted, except those where that was known.
  [[nodiscard]] const std::vector<Index>& failed() const { return failed_; }

 private:
  /// A unit, and the positions to which it can move.
  struct Found {
    Index unit = 0;
    Vec3 to;
  };

  /// Returns how many units must move, so that no two are left at any place.
  [[nodiscard]] std::size_t n_moves() const {
    std::size_t n = 0;
    for (const ContactPlace& place : contacts_.places) n += place.units.size() - 1;
    return n;
  }

  /// Returns the numbers of the places: the first ones, and last those that have failed before,
  /// because others are to have their turn while pairs may still be checked.
  [[nodiscard]] std::vector<Index> places_in_order(std::span<const Index> first) const {
    std::vector<Index> order(contacts_.places.size());
    std::iota(order.begin(), order.end(), Index{0});
    if (memory_) {
      std::stable_partition(order.begin(), order.end(),
                            [&](Index i) { return !memory_->has_failed(keys_[i]); });
    }
    std::vector<std::uint8_t> is_first(order.size(), 0);
    for (const Index i : first) is_first[i] = 1;
    std::stable_partition(order.begin(), order.end(), [&](Index i) { return is_first[i] != 0; });
    return order;
  }

  /// Parts the units of a place unless that is known to be in vain; returns the moved vertices.
  std::vector<Index> part_unless_known(Index i) {
    const ContactPlace& place = contacts_.places[i];
    if (!memory_) return part(i);
    const std::size_t n_checks = n_checks_left_;
    if (const auto n_in_vain = memory_->recall(keys_[i], n_checks)) {
      n_checks_left_ -= *n_in_vain;
      refuse(place, place.contacts.front());
      return {};
    }
    region_.setEmpty();
    std::vector<Index> moved = part(i);
    if (moved.empty() && !region_.isEmpty()) {
      memory_->note(keys_[i], {.region = region_,
                               .n_checks = n_checks - n_checks_left_,
                               .has_run_out = n_checks_left_ == 0});
    }
    return moved;
  }

  /// Moves units of a place until none touches another, as far as possible; returns the moved
  /// vertices.
  std::vector<Index> part(Index i) {
    const ContactPlace& place = contacts_.places[i];
    std::vector<Index> moved;
    std::vector<std::array<Index, 2>> contacts = place.contacts;
    std::vector<Index> candidates = units_that_may_move(place);
    while (!contacts.empty()) {
      const std::vector<Index> units = next_to_move(candidates, contacts);
      if (units.empty()) {
        refuse(place, contacts.front());
        failed_.push_back(i);
        break;
      }
      const std::optional<Found> found = find_move(place, units);
      std::erase_if(candidates, [&](Index unit) {
        return found ? unit == found->unit
                     : std::find(units.begin(), units.end(), unit) != units.end();
      });
      if (!found) continue;
      const std::vector<Index>& unit = place.units[found->unit];
      mesh_.move(unit, found->to);
      moved.insert(moved.end(), unit.begin(), unit.end());
      std::erase_if(contacts, [&](const std::array<Index, 2>& contact) {
        return contact[0] == found->unit || contact[1] == found->unit;
      });
    }
    return moved;
  }

  [[nodiscard]] bool may_move(const std::vector<Index>& unit) const {
    return std::none_of(unit.begin(), unit.end(),
                        [&](Index v) { return input_.limits.is_fixed(input_.tracked, v); });
  }

  /// Returns the units with the last first, because those are the copies.
  [[nodiscard]] std::vector<Index> units_that_may_move(const ContactPlace& place) const {
    std::vector<Index> units;
    for (auto unit = static_cast<Index>(place.units.size()); unit-- > 0;) {
      if (may_move(place.units[unit])) units.push_back(unit);
    }
    return units;
  }

  /// Returns the first few of the candidates that touch others.
  [[nodiscard]] static std::vector<Index> next_to_move(
      const std::vector<Index>& candidates, const std::vector<std::array<Index, 2>>& contacts) {
    std::vector<Index> units;
    for (const Index unit : candidates) {
      const bool touches =
          std::any_of(contacts.begin(), contacts.end(),
                      [&](const std::array<Index, 2>& c) { return c[0] == unit || c[1] == unit; });
      if (touches) units.push_back(unit);
      if (units.size() == kUnitsAtOnce) break;
    }
    return units;
  }

  [[nodiscard]] std::optional<Found> find_move(const ContactPlace& place,
                                               const std::vector<Index>& units) {
    std::vector<std::vector<Index>> faces;
    for (const Index unit : units) faces.push_back(faces_of(place.units[unit]));
    const Trial trial{.place = place, .units = units, .faces = faces};
    const auto chosen_directions = [&](std::size_t i) {
      return parting_directions(corners_of(place.units[units[i]], faces[i]));
    };
    if (auto found = search(trial, chosen_directions, kFineGrowth)) return found;
    return search(
        trial, [](std::size_t) { return grid_directions(); }, kCoarseGrowth);
  }

  /// Returns the faces round a unit, ascending.
  [[nodiscard]] std::vector<Index> faces_of(const std::vector<Index>& unit) const {
    std::vector<Index> faces;
    for (const Index v : unit) {
      const auto of_vertex = contacts_.incident.faces(contacts_.incident.entry_of(v));
      faces.insert(faces.end(), of_vertex.begin(), of_vertex.end());
    }
    sort_unique(faces);
    return faces;
  }

  /// Returns the corners of the faces round a unit, each with the vertex of the unit first.
  [[nodiscard]] std::vector<Corners> corners_of(const std::vector<Index>& unit,
                                                const std::vector<Index>& faces) const {
    std::vector<Corners> corners;
    for (const Index face : faces) {
      Triangle t = mesh_.triangle(face);
      const auto first = std::find_first_of(t.begin(), t.end(), unit.begin(), unit.end());
      std::rotate(t.begin(), first, t.end());
      corners.push_back(mesh_.corners(t));
    }
    return corners;
  }

  /// The data of the attempts at a place; the lists are indexed as `units`.
  struct Trial {
    const ContactPlace& place;
    const std::vector<Index>& units;
    const std::vector<std::vector<Index>>& faces;
  };

  /// A unit that may move, in these directions. Most units are never needed, so that each is
  /// created on demand.
  struct Candidate {
    std::vector<Vec3> directions;
    Move move;
  };

  using Directions = std::function<std::vector<Vec3>(std::size_t)>;

  /// Returns the smallest sufficient step, of any unit in any direction.
  [[nodiscard]] std::optional<Found> search(const Trial& trial, const Directions& directions,
                                            double growth) {
    // The limit is finite, so that the steps come to an end.
    const double max =
        std::min(input_.limits.max_deviation, std::numeric_limits<double>::max() / 2);
    double reach = std::min(max, kLookupReach * first_step_);
    std::vector<std::optional<Candidate>> candidates(trial.units.size());
    for (double step = first_step_; step <= max && n_checks_left_ > 0; step *= growth) {
      if (step > reach) {
        reach = std::min(max, kLookupReach * step);
        candidates = std::vector<std::optional<Candidate>>(trial.units.size());
      }
      bool is_hopeless = true;
      for (std::size_t i = 0; i < trial.units.size(); ++i) {
        const std::vector<Index>& unit = trial.place.units[trial.units[i]];
        if (!candidates[i]) {
          candidates[i].emplace(Candidate{directions(i), Move(mesh_, unit, trial.faces[i], reach)});
          n_checks_left_ -= std::min(n_checks_left_, candidates[i]->move.n_checks_to_find());
          region_.extend(candidates[i]->move.region());
        }
        if (candidates[i]->move.is_crowded()) continue;
        is_hopeless = false;
        if (auto to = place_to_go(*candidates[i], unit, {step, max})) {
          return Found{.unit = trial.units[i], .to = *to};
        }
      }
      if (is_hopeless) break;
    }
    return std::nullopt;
  }

  /// The length of a step, and its maximum after rounding.
  struct StepLength {
    double step;
    double max;
  };

  [[nodiscard]] std::optional<Vec3> place_to_go(Candidate& candidate,
                                                const std::vector<Index>& unit,
                                                const StepLength& length) {
    const Vec3& from = mesh_.position(unit.front());
    for (const Vec3& direction : candidate.directions) {
      const Vec3 to = from + length.step * direction;
      const double distance = (to - from).stableNorm();
      if (distance > 0.0 && distance <= length.max &&
          candidate.move.is_accepted(to, n_checks_left_)) {
        return to;
      }
    }
    return std::nullopt;
  }

  void refuse(const ContactPlace& place, const std::array<Index, 2>& contact) {
    const bool is_free = may_move(place.units[contact[0]]) || may_move(place.units[contact[1]]);
    result_.refused.push_back(
        {.code = DefectCode::NonManifold,
         .vertex = place.units[contact[0]].front(),
         .reason = is_free ? "no step within the deviation was found that parts the faces"
                           : "vertices that touch must stay where they are"});
  }

  const PassInput& input_;
  const ContactPlaces& contacts_;
  MovedMesh mesh_;
  double first_step_ = 0.0;
  /// The number of pairs of faces that may still be checked at the current place.
  std::size_t n_checks_left_ = 0;
  /// Nothing if the pass runs outside of a repair.
  std::optional<PartingMemory> memory_;
  /// The keys of all places, if there is a memory.
  std::vector<std::uint64_t> keys_;
  /// The region of all moves that were considered at the current place.
  Box3 region_;
  PassResult result_;
  std::vector<Index> failed_;
};

}  // namespace

PassResult part_contacts(const PassInput& input) {
  const ContactPlaces contacts = find_contact_places(input.tracked, input.mesh);
  if (contacts.places.empty()) return {};
  Parting parting(input, contacts);
  PassResult result = parting.part_all({});
  if (!may_be_in_the_way(parting.failed().size(), contacts.places.size())) return result;
  PassResult other = Parting(input, contacts).part_all(parting.failed());
  if (other.refused.size() < result.refused.size()) return other;
  return result;
}

}  // namespace meshalyzer
