#include "meshalyzer/base/require.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"

#include <cmath>
#include <string>

namespace meshalyzer {
namespace {

[[noreturn]] void throw_refused(std::string_view what, const std::string& value,
                                const std::string& why) {
  throw InvalidArgument(std::string(what) + " is " + value + ", which is " + why);
}

}  // namespace

void require_number(std::string_view what, std::optional<double> value) {
  if (value && std::isnan(*value)) throw_refused(what, shortest(*value), "no number");
}

void require_length(std::string_view what, std::optional<double> value) {
  if (!value || (*value >= 0.0 && std::isfinite(*value))) return;
  throw_refused(what, shortest(*value), "no length");
}

void require_positive_length(std::string_view what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw_refused(what, shortest(value), "no length above 0");
}

void require_seconds(std::string_view what, std::optional<double> value) {
  if (!value || *value >= 0.0) return;
  throw_refused(what, shortest(*value), "no number of seconds, 0 or more");
}

void require_angle(std::string_view what, std::optional<double> degrees, double largest) {
  if (!degrees || (*degrees >= 0.0 && *degrees <= largest)) return;
  throw_refused(what, shortest(*degrees) + " degrees", "not within 0 and " + shortest(largest));
}

void require_point(std::string_view what, const Vec3& point) {
  if (point.allFinite()) return;
  throw_refused(what, shortest(point.x()) + " " + shortest(point.y()) + " " + shortest(point.z()),
                "no point");
}

void throw_null(std::string_view what) {
  throw InvalidArgument(std::string(what) + " is null");
}

}  // namespace meshalyzer
