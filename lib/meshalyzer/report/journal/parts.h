#pragma once

#include "meshalyzer/report/journal/subject.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Returns the subject of the journals of all parts of a run: the files as they were when the lines
/// were written, and the request.
///
/// @throws IoError  if a journal cannot be read, is none, or is of another version or another run
///                  than the first, or if no journal has a line of some file.
[[nodiscard]] JournalSubject read_subject(const std::vector<std::string>& journals);

}  // namespace meshalyzer
