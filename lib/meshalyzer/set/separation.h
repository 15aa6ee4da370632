#pragma once

#include "meshalyzer/base/types.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// Selects the points that count when the separation of objects is measured.
struct SeparationOptions {
  /// Vertices with nothing closer than this are counted, not measured.
  std::optional<double> search_radius = std::nullopt;
  /// Leaves out points whose direction is more than this number of degrees from the vertex normal,
  /// 0 ... 90.
  std::optional<double> search_cone_degrees = std::nullopt;
  /// Includes the object's own surface, but for faces with a vertex that is reached along edges
  /// within this length.
  std::optional<double> include_self = std::nullopt;

  friend bool operator==(const SeparationOptions&, const SeparationOptions&) = default;
};

/// The closest point of any other object for each vertex of one object, in columns of equal length.
struct ObjectSeparation {
  /// Ids of the vertices that faces use, in file order.
  std::vector<std::int64_t> vertices;
  /// Negative where the vertex lies inside another object; NaN where nothing was found.
  std::vector<double> distances;
  /// The object that the closest point is on; kNoIndex where nothing was found.
  std::vector<Index> objects;
  /// The id of its face; of several at the same distance the one of the first object, then the
  /// first in its file.
  std::vector<std::int64_t> faces;
  std::vector<Vec3> points;
};

}  // namespace meshalyzer
