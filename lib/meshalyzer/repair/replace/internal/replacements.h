#pragma once

#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/passes.h"

#include <cstdint>

namespace meshalyzer {

// The replacements of what is broken by new surfaces. Unlike passes they measure what they propose.

/// The extent of replace_broken_solids(), and its limits.
struct ReplaceOptions {
  /// Only the broken parts are replaced, or all of the mesh.
  enum class Scope : std::uint8_t { Broken, Whole };
  Scope scope = Scope::Broken;
  /// Tells whether parts that bound no solid may be lost.
  enum class Sheets : std::uint8_t { Kept, Dropped };
  Sheets sheets = Sheets::Kept;
  /// The maximum distance between the new surface and the replaced one.
  double max_deviation = 0.0;
};

/// The extent of replace_in_boxes(), and its limits.
struct BoxOptions {
  /// The distance between broken faces and the sides of their boxes; a length above 0.
  double margin = 0.0;
  /// The maximum distance between the new surface and the replaced one.
  double max_deviation = 0.0;
  /// Tells whether components that bound a solid may be lost.
  LostParts lost = LostParts::Refused;
};

/// The proposal of replace_in_boxes() or replace_broken_solids().
struct Replacement {
  PassResult result;
  /// The largest distance between the new surface and the replaced one that sampling has found.
  double deviation = 0.0;
  /// Tells whether nothing was proposed because a grid would have needed too many tetrahedra.
  bool needs_larger_grid = false;
};

/// Replaces what lies in the smallest boxes that hold the broken faces by the contour of the solid
/// there (see contour_mesh()), and unites it with the surface outside them by one exact arrangement
/// (see combine_solids()). Faces outside the boxes that do not meet their sides stay as they are.
///
/// It refuses where the boxes would hold most of the mesh.
[[nodiscard]] Replacement replace_in_boxes(const PassInput& input, const BoxOptions& options);

/// Replaces the broken components, and those that they intersect, by the contour of the solid that
/// they mean (see contour_mesh()). Walls inside the solid are removed, and holes are closed.
[[nodiscard]] Replacement replace_broken_solids(const PassInput& input,
                                                const ReplaceOptions& options);

}  // namespace meshalyzer
