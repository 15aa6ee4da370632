#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/tree.h"

namespace meshalyzer {

/// What write_offenders() wrote; lists that it left out stay empty. In the place of each record
/// stands its id, see index_records().
[[nodiscard]] Offenders read_offenders(const JsonNode& object);

/// What write_numbering() wrote.
[[nodiscard]] NumberingBreak read_numbering(const JsonNode& object);

/// What contact_name() called it.
[[nodiscard]] ContactKind read_contact(const JsonNode& node);

/// The id of a record in its place, see index_records().
/// @throws InvalidArgument where it is none that a file can have.
[[nodiscard]] Index read_id(const JsonNode& node);

}  // namespace meshalyzer
