#include "meshalyzer/repair/driver/rejection.h"

namespace meshalyzer {

std::string_view rejection_reason(Rejection rejection) {
  switch (rejection) {
    case Rejection::None:
      return "";
    case Rejection::TooFar:
      return "undone: it would move the surface farther than the maximum deviation";
    case Rejection::Intersects:
      return "undone: it would make faces intersect";
    case Rejection::MoreDefects:
      return "undone: it would make more defects than it mends";
    case Rejection::MendsNothing:
      return "undone: it would leave as many intersecting faces and border edges as there were";
    case Rejection::EndsWorse:
      return "undone: it would make the final mesh worse";
  }
  return "";
}

}  // namespace meshalyzer
