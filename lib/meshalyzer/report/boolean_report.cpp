#include "meshalyzer/report/boolean_report.h"

namespace meshalyzer {

std::string_view operation_name(BooleanOperation operation) {
  switch (operation) {
    case BooleanOperation::Union:
      return "union";
    case BooleanOperation::Intersection:
      return "intersection";
    case BooleanOperation::Difference:
      return "difference";
    case BooleanOperation::SubtractInOrder:
      return "subtract-in-order";
  }
  return "";
}

}  // namespace meshalyzer
