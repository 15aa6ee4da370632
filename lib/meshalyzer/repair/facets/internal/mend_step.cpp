#include "meshalyzer/repair/facets/internal/mend_step.h"

namespace meshalyzer {

std::string_view mend_reason(MendOutcome outcome) {
  switch (outcome) {
    case MendOutcome::Hopeless:
      return "no edge of it can be flipped or collapsed";
    case MendOutcome::Topology:
      return "taking it away would change the topology";
    case MendOutcome::Fixed:
      return "its vertices have to stay where they are";
    case MendOutcome::GroupBorder:
      return "taking it away would change the border of a group";
    case MendOutcome::TooFar:
      return "taking it away would move the surface farther than the maximum deviation";
    case MendOutcome::MakesThin:
      return "taking it away would make its neighbours flat";
    case MendOutcome::TurnsOver:
      return "taking it away would turn a neighbour over";
    case MendOutcome::Intersects:
      return "taking it away would make faces intersect";
    case MendOutcome::Possible:
      break;
  }
  return "";
}

const MendAttempt& better(const MendAttempt& a, const MendAttempt& b) {
  if (a.is_possible() && b.is_possible()) return b.deviation < a.deviation ? b : a;
  return b.outcome > a.outcome ? b : a;
}

}  // namespace meshalyzer
