#include "support/packing_plan.h"

#include "meshalyzer/base/error.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer::test {
namespace {

Index as_index(std::size_t i) {
  return static_cast<Index>(i);
}

/// Lets every second object of a row reach for the next one, as often as is asked for.
void plan_meetings(PackingPlan& plan, const PackOptions& options) {
  const std::size_t wanted = options.n_crossing + options.n_touching;
  for (std::size_t i = 0; i < plan.n_lattice && plan.pairs.size() < wanted; ++i) {
    if (plan.cell_of(i)[0] % 2 != 0 || !plan.has_neighbour(i)) continue;
    const bool crosses = plan.pairs.size() < options.n_crossing;
    plan.reach[i] = crosses ? Relation::Crossing : Relation::Touching;
    plan.is_engaged[i + 1] = 1;
    plan.pairs.push_back({as_index(i), as_index(i + 1), *plan.reach[i]});
  }
  if (plan.pairs.size() < wanted) {
    throw InvalidArgument("fewer neighbours than are to cross or touch");
  }
}

/// The hosts are the last objects of the lattice, so that nothing reaches into them.
void plan_hosts(PackingPlan& plan, const PackOptions& options) {
  const std::size_t n_free =
      plan.n_lattice - (plan.pairs.empty() ? 0 : std::size_t{plan.pairs.back().b} + 1);
  if (options.n_contained > n_free) {
    throw InvalidArgument("fewer objects than are to hold others");
  }
  for (std::size_t i = plan.n_lattice; i < options.n_objects; ++i) {
    const std::size_t host = plan.place_of(i);
    plan.is_engaged[host] = 1;
    plan.pairs.push_back({as_index(i), as_index(host), Relation::Contained});
  }
}

}  // namespace

std::array<std::size_t, 3> PackingPlan::cell_of(std::size_t object) const {
  return {object % n_columns, object / n_columns % n_rows, object / n_columns / n_rows};
}

std::size_t PackingPlan::place_of(std::size_t object) const {
  return object < n_lattice ? object : 2 * n_lattice - 1 - object;
}

bool PackingPlan::has_neighbour(std::size_t object) const {
  return cell_of(object)[0] + 1 < n_columns && object + 1 < n_lattice;
}

const PackOptions& checked(const PackOptions& options) {
  if (!(options.gap > 0 && options.gap <= 2)) {
    throw InvalidArgument("the gap must be in (0, 2]");
  }
  if (!(options.overlap > 0 && options.overlap <= 0.5)) {
    throw InvalidArgument("the overlap must be in (0, 1/2]");
  }
  if (options.n_contained >= options.n_objects) {
    throw InvalidArgument("not every object can be inside another");
  }
  return options;
}

PackingPlan make_plan(const PackOptions& options, double layer_height) {
  PackingPlan plan;
  plan.n_lattice = options.n_objects - options.n_contained;
  const auto n = static_cast<double>(plan.n_lattice);
  const double layers = std::max(1.0, std::round(std::cbrt(n / (layer_height * layer_height))));
  plan.n_columns = static_cast<std::size_t>(std::ceil(std::sqrt(n / layers)));
  plan.n_rows =
      static_cast<std::size_t>(std::ceil(n / layers / static_cast<double>(plan.n_columns)));
  plan.reach.resize(plan.n_lattice);
  plan.is_engaged.resize(plan.n_lattice);
  plan_meetings(plan, options);
  plan_hosts(plan, options);
  return plan;
}

std::string object_name(std::size_t object, std::size_t n) {
  const std::string number = std::to_string(object + 1);
  return std::string(std::to_string(n).size() - number.size(), '0') + number + ".mesh";
}

}  // namespace meshalyzer::test
