#pragma once

#include "file_identity.h"

#include <map>
#include <set>
#include <string>

namespace meshalyzer {

/// The files that a run reads and writes, collected before anything is written: no output may be an
/// input or another output, whatever links or spellings name them.
///
/// Standard streams ("-") and files that are not regular (pipes, devices) are ignored.
class RunFiles {
 public:
  /// Adds a file that is read and must not change. All inputs are added before the outputs.
  void add_input(const std::string& path);

  /// Adds a file that is written or replaced.
  ///
  /// @param what  The content, as in "the report of --json".
  /// @throws UsageError if the file is an input, or an output already.
  void add_output(const std::string& path, const std::string& what);

 private:
  std::set<FileIdentity> inputs_;
  /// The content of each output.
  std::map<FileIdentity, std::string> outputs_;
};

}  // namespace meshalyzer
