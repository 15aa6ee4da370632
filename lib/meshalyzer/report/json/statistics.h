#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/json/writer.h"

#include <initializer_list>
#include <string_view>

namespace meshalyzer {

/// Writes statistics as a value (contract 4, STAT).
void write_statistics(JsonWriter& json, const Statistics& statistics);

/// The same without a histogram, in one line.
void write_summary(JsonWriter& json, const Summary& summary);

/// A real that is a member of a JSON object.
struct NamedReal {
  std::string_view name;
  double value = 0.0;
};

/// Where any of the reals is infinite or NaN, writes a further member "non_finite" that tells which
/// of these the null of each stands for: "inf", "-inf", "nan" or "-nan".
void write_non_finite(JsonWriter& json, std::initializer_list<NamedReal> reals);

}  // namespace meshalyzer
