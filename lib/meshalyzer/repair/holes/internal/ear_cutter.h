#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/repair/holes/internal/corner_grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {

/// The requirements for an ear to be cut; each demands less than the one before.
enum class EarDemand : std::uint8_t { ConvexAndEmpty, Convex, Nothing };

/// What decides which ears are cut, and which of them first. An ear is the triangle of a corner and
/// its two neighbours, by number: {before, tip, after}.
struct EarRules {
  /// Returns the cost of an ear; of several ears the one with the lowest cost is cut first, of
  /// equal ones that with the lowest tip.
  std::function<double(const Triangle&)> cost;
  /// Tells whether an ear may be cut. It is not called for the last three corners, which need no
  /// new edge.
  std::function<bool(const Triangle&)> allows;
};

/// Cuts ears off a polygon in space (Meisters 1975, "Polygons have ears"), as seen along an axis,
/// or each ear along the axis that shows the surface round its tip best. Turns of corners, and
/// whether a corner lies in an ear, are decided exactly.
class EarCutter {
 public:
  /// @param polygon  Its corners, counter-clockwise in the views. This and the rules are referred
  /// to, not copied.
  /// @param views  One for all ears, or one for each corner as a tip. Then corners that are farther
  /// from an ear in depth than it is long do not lie in it.
  EarCutter(std::span<const Vec3> polygon, std::vector<PlaneView> views, const EarRules& rules);

  /// Cuts ears that meet a demand, until the given number of corners is left or no ear in the queue
  /// meets it. A rejected ear is not examined again before one of its neighbours is cut, although
  /// the corner that lay in it may be gone: call this again for such ears.
  ///
  /// @param n_wanted  2 or more.
  /// @complexity      O(n log n) for corners that are about evenly spread.
  void cut(EarDemand demand, std::size_t n_wanted);

  [[nodiscard]] std::size_t n_left() const { return n_left_; }
  [[nodiscard]] std::vector<Index> corners_left() const;
  /// Returns the ears that were cut, in order.
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  /// An ear as it was when its cost was computed.
  struct Ear {
    double cost = 0.0;
    Triangle corners;

    [[nodiscard]] Index tip() const { return corners[1]; }
    /// Tells whether it is to be cut later than another.
    friend bool operator<(const Ear& a, const Ear& b) {
      return std::pair(a.cost, a.tip()) > std::pair(b.cost, b.tip());
    }
  };

  /// The remaining corners in the projections along the axes of the views.
  using Grids = std::array<std::optional<CornerGrid>, 3>;

  [[nodiscard]] bool has_one_view() const { return views_.size() == 1; }
  [[nodiscard]] const PlaneView& view_at(Index tip) const {
    return views_[has_one_view() ? 0 : tip];
  }
  [[nodiscard]] CornerGrid::Point flat(Axis dropped, Index corner) const;
  [[nodiscard]] Grids make_grids() const;
  [[nodiscard]] Ear ear_at(Index tip) const;
  [[nodiscard]] bool is_current(const Ear& ear) const;
  [[nodiscard]] bool meets(EarDemand demand, const Triangle& ear, const Grids& grids) const;
  /// Tells whether no other remaining corner lies in the ear.
  [[nodiscard]] bool is_empty(const Triangle& ear, const Grids& grids) const;
  /// Returns how far from an ear, along the axis of its view, corners may be that lie in it.
  [[nodiscard]] double depth_of(const Triangle& ear) const;
  void remove_tip(const Triangle& ear);

  std::span<const Vec3> polygon_;
  std::vector<PlaneView> views_;
  const EarRules& rules_;
  std::size_t n_left_;
  /// The neighbours of each corner among those left.
  std::vector<Index> before_;
  std::vector<Index> after_;
  std::vector<std::uint8_t> is_left_;
  std::vector<Triangle> triangles_;
};

}  // namespace meshalyzer
