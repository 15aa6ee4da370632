#pragma once

#include "exit_code.h"
#include "meshalyzer/io/file.h"
#include "options.h"
#include "streams.h"

#include <ostream>

namespace meshalyzer::fixer {

/// Writes a report as text and as JSON, if these are requested.
template <typename Text, typename Json>
ExitCode write_report(const Options& options, Streams streams, Text text, Json json) {
  if (options.json && !options.json->is_stdout()) replace_file(options.json->file, json());
  streams.out << (options.json && options.json->is_stdout() ? json() : text()) << std::flush;
  if (streams.out) return ExitCode::Done;
  streams.err << "meshfixer: standard output takes no more\n";
  return ExitCode::Failure;
}

}  // namespace meshalyzer::fixer
