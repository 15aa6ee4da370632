#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// A shape and what is true of it, from the formulas in shapes.h.
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
  /// Without a value where the shape is not manifold.
  std::optional<bool> orientable = true;
  std::optional<bool> consistent = true;
  /// Without a value where the shape is not closed, or encloses no volume.
  std::optional<bool> outward = true;
  std::optional<std::int64_t> genus = 0;
  /// Without a value where no formula tells.
  std::optional<double> area = std::nullopt;
  /// Without a value where the shape bounds no solid.
  std::optional<double> volume = std::nullopt;

  [[nodiscard]] bool is_closed() const { return border_edges == 0; }
};

/// Every shape of shapes.h.
[[nodiscard]] std::vector<ShapeFigures> all_shapes();

}  // namespace meshalyzer
