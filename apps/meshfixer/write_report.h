#pragma once

#include "exit_code.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "options.h"
#include "print_answer.h"
#include "streams.h"
#include "usage_error.h"

#include <string>

namespace meshalyzer::fixer {

/// Writes a report as text and as JSON, if these are requested.
template <typename Text, typename Json>
ExitCode write_report(const Options& options, Streams streams, Text text, Json json) {
  if (options.json && !options.json->is_stdout()) replace_file(options.json->file, json());
  return print_answer(options.json && options.json->is_stdout() ? json() : text(), "meshfixer",
                      streams);
}

/// Writes in place of a report in JSON, if that is requested, why there is none. So the file of an
/// earlier run is not taken for the report of this one.
void write_reason_of_no_report(const Options& options, Streams streams, const std::string& reason);

/// Does work that ends with a report. If it fails, what it throws is also the reason in JSON.
///
/// The files of the run must have been checked: a report is not to be written over an input.
template <typename Work>
ExitCode report_or_reason(const Options& options, Streams streams, Work work) {
  try {
    return work();
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {
    write_reason_of_no_report(options, streams, error.what());
    throw;
  }
}

}  // namespace meshalyzer::fixer
