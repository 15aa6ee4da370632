#include "meshalyzer/repair/driver/internal/reason_left.h"

#include "meshalyzer/base/grouped_digits.h"

namespace meshalyzer {

bool has_too_many_pairs(const RepairDriver& driver) {
  return driver.mesh().prepared().was_intersection_search_cut() &&
         driver.mesh().prepared().intersecting_pairs().size() == driver.mesh().max_pairs();
}

std::string reason_against_repair(const RepairDriver& driver) {
  if (!driver.mesh().prepared().was_intersection_search_cut()) return "";
  if (!has_too_many_pairs(driver)) {
    return "the repair was stopped before all intersecting faces were found";
  }
  return "more than " + grouped(driver.mesh().max_pairs()) +
         " pairs of faces intersect, and no mesh with so many is repaired";
}

std::string reason_of_defects_left(const RepairDriver& driver) {
  if (std::string reason = reason_against_repair(driver); !reason.empty()) return reason;
  return driver.is_stopped() ? "the repair was stopped before"
                             : "no pass found a way within the maximum deviation";
}

}  // namespace meshalyzer
