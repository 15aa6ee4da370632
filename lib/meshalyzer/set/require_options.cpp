#include "meshalyzer/set/require_options.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/require.h"

namespace meshalyzer {

void require_valid(const SeparationOptions& options) {
  require_length("the search radius", options.search_radius);
  require_angle("the angle of the search cone", options.search_cone_degrees, 90.0);
  require_length("the length within which the own surface is left out", options.include_self);
}

void require_valid(const SetOptions& options) {
  if (options.request.between.separation) require_valid(*options.request.between.separation);
  require_seconds("the time limit", options.request.time_limit);
  if (options.shard.number >= options.shard.count) {
    throw InvalidArgument("the number of the shard is not below the number of shards");
  }
}

}  // namespace meshalyzer
