#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// A shape and its true figures, from the formulas in shapes.h.
struct ShapeFigures {
  std::string name;
  Soup soup;
  std::size_t edges = 0;
  std::size_t components = 1;
  std::size_t edge_components = 1;
  std::size_t boundaries = 0;
  std::size_t border_edges = 0;
  std::size_t non_manifold_edges = 0;
  std::size_t non_manifold_vertices = 0;
  std::size_t pinched_vertices = 0;
  bool manifold = true;
  /// Empty if the shape is not manifold.
  std::optional<bool> orientable = true;
  std::optional<bool> consistent = true;
  /// Empty if the shape is not closed, or encloses no volume.
  std::optional<bool> outward = true;
  std::optional<std::int64_t> genus = 0;
  /// Empty if no formula is known.
  std::optional<double> area = std::nullopt;
  /// Empty if the shape bounds no solid.
  std::optional<double> volume = std::nullopt;

  [[nodiscard]] bool is_closed() const { return border_edges == 0; }
};

/// Returns every shape of shapes.h.
[[nodiscard]] std::vector<ShapeFigures> all_shapes();

}  // namespace meshalyzer
