#include "meshalyzer/spatial/intersecting_pair.h"

namespace meshalyzer {

std::string_view contact_name(ContactKind kind) {
  switch (kind) {
    case ContactKind::Duplicate:
      return "duplicate";
    case ContactKind::Unwelded:
      return "unwelded";
    case ContactKind::FoldOver:
      return "fold-over";
    case ContactKind::CoplanarOverlap:
      return "coplanar-overlap";
    case ContactKind::Crossing:
      return "crossing";
    case ContactKind::Touching:
      return "touching";
  }
  return "";
}

}  // namespace meshalyzer
