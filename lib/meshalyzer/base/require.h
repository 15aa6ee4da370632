#pragma once

#include "meshalyzer/base/types.h"

#include <functional>
#include <optional>
#include <string_view>

namespace meshalyzer {

// The checks of the values that a caller passes: of options that are numbers, and of functions. A
// function that takes such values calls these before it does anything else, so that a senseless
// value is refused whether it would have been used or not.
//
// Each throws InvalidArgument. `what` names the value and begins the message, as in "the slit
// tolerance". An absent option is no fault.

/// Refuses NaN.
void require_number(std::string_view what, std::optional<double> value);
/// Refuses what is negative or not finite.
void require_length(std::string_view what, std::optional<double> value);
/// Refuses what is not above 0 or not finite.
void require_positive_length(std::string_view what, double value);
/// Refuses what is negative or NaN; infinite is forever.
void require_seconds(std::string_view what, std::optional<double> value);
/// Refuses what is not within 0 and `largest` degrees.
void require_angle(std::string_view what, std::optional<double> degrees, double largest);
/// Refuses a point with a coordinate that is not finite.
void require_point(std::string_view what, const Vec3& point);

/// Throws because a pointer or function is null.
[[noreturn]] void throw_null(std::string_view what);

/// Refuses a function that is null.
template <typename Signature>
void require_function(std::string_view what, const std::function<Signature>& function) {
  if (!function) throw_null(what);
}

}  // namespace meshalyzer
