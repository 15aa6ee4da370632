#pragma once

#include "meshalyzer/picture/internal/drawing_frame.h"
#include "meshalyzer/picture/internal/edge_lengths.h"
#include "meshalyzer/picture/internal/highlighted_elements.h"
#include "meshalyzer/picture/scene.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// The scene in which defects and changes are highlighted. The caller keeps the data.
struct HighlightContext {
  const Soup& soup;
  const DrawingFrame& frame;
  const EdgeLengths& lengths;
  const DrawnSurface& detail;
};

/// Highlights each defect or change: its faces if they are drawn in detail; as segments its edges,
/// the contact of its intersecting pairs, and the outlines of faces that are too thin to be seen;
/// as points its vertices, pairs that touch at a point and, if nothing else is visible, its
/// positions.
///
/// The view has a margin of a few edge lengths round it.
[[nodiscard]] std::vector<Highlight> make_highlights(const HighlightContext& place,
                                                     std::span<const HighlightedElements> elements);

}  // namespace meshalyzer
