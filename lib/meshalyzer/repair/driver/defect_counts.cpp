#include "meshalyzer/repair/driver/defect_counts.h"

namespace meshalyzer {

std::string_view name_of(CountedDefect kind) {
  switch (kind) {
    case CountedDefect::NonManifoldEdges:
      return "non-manifold edges";
    case CountedDefect::NonManifoldVertices:
      return "non-manifold vertices";
    case CountedDefect::PinchedVertices:
      return "pinched vertices";
    case CountedDefect::IntersectingPairs:
      return "intersecting pairs";
    case CountedDefect::FlippedEdges:
      return "flipped edges";
    case CountedDefect::BorderEdges:
      return "border edges";
    case CountedDefect::SlitEdges:
      return "slit edges";
    case CountedDefect::DuplicateFaces:
      return "duplicate faces";
    case CountedDefect::ZeroAreaFaces:
      return "zero-area faces";
  }
  return "";
}

}  // namespace meshalyzer
