#pragma once

#include "meshalyzer/report/journal/subject.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Returns the subject of the journals of all parts of a run: the files as they were when the lines
/// were written, and what was asked about them.
///
/// @throws IoError  A journal cannot be read, is none or of another version of meshalyzer, is of
/// another run than the first, or there are files of which no journal has a line.
[[nodiscard]] JournalSubject read_subject(const std::vector<std::string>& journals);

}  // namespace meshalyzer
