#pragma once

#include "meshalyzer/analysis/field_info.h"
#include "meshalyzer/base/statistics.h"

#include <array>

namespace meshalyzer {

/// The figures of a summary, in the order of reports; a summary of no value has none.
inline constexpr std::array kFigures{
    FieldRow<Summary, double>{{.key = "min", .label = "min"}, &Summary::min},
    FieldRow<Summary, double>{{.key = "max", .label = "max"}, &Summary::max},
    FieldRow<Summary, double>{{.key = "mean", .label = "mean"}, &Summary::mean},
    FieldRow<Summary, double>{
        {.key = "median",
         .label = "median",
         .definition = "the middle value; the mean of the two middle ones where count is even"},
        &Summary::median},
    FieldRow<Summary, double>{
        {.key = "variance", .label = "variance", .definition = "with n - 1 in the denominator"},
        &Summary::variance},
    FieldRow<Summary, double>{{.key = "total", .label = "total", .definition = "the sum"},
                              &Summary::total},
};

/// Tells whether reports for people show a figure of a quantity.
[[nodiscard]] constexpr bool is_shown(const FieldRow<Summary, double>& figure,
                                      const Quantity& quantity) {
  return figure.member != &Summary::total || quantity.total == Quantity::Total::Show;
}

}  // namespace meshalyzer
