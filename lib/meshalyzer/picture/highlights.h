#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/picture/drawing_frame.h"
#include "meshalyzer/picture/edge_lengths.h"
#include "meshalyzer/picture/lit_defects.h"
#include "meshalyzer/picture/scene.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to the picture module: defects lit up.

/// Where defects are lit up. Only refers to what it is given.
struct LitPlace {
  const Soup& soup;
  const DefectReport& report;
  const DrawingFrame& frame;
  const EdgeLengths& lengths;
  const DrawnSurface& detail;
};

/// What is lit up of each defect: its faces as far as they are in detail; its edges, the contact of
/// its intersecting pairs, and the outlines of faces that are too thin to be seen; its vertices,
/// pairs that touch at a point, and where there is nothing else to be seen, its positions.
///
/// Round it so much is to be seen as a few edges are long.
[[nodiscard]] std::vector<Highlight> make_highlights(const LitPlace& place,
                                                     std::span<const LitDefect> lit);

}  // namespace meshalyzer
