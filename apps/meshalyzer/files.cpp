#include "files.h"

#include "file_identity.h"
#include "run_files.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

void add_inputs(const Options& options, const Inputs& inputs, RunFiles& files) {
  for (const auto* paths : {&options.paths, &inputs.files}) {
    for (const std::string& path : *paths) files.add_input(path);
  }
  // A journal that is only read, not continued.
  if (options.resume && !is_same_file(*options.resume, options.ndjson->file)) {
    files.add_input(*options.resume);
  }
}

void add_target(const std::optional<ReportTarget>& target, const std::string& what,
                RunFiles& files) {
  if (target) files.add_output(target->file, what);
}

void add_pictures(const std::vector<std::string>& pictures, const std::string& what,
                  const Inputs& inputs, RunFiles& files) {
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    files.add_output(pictures[i], what + " of " + inputs.files[i]);
  }
}

}  // namespace

void check_files(const Options& options, const Inputs& inputs, const PicturePaths& pictures) {
  RunFiles files;
  add_inputs(options, inputs, files);
  add_target(options.json, "the report of --json", files);
  add_target(options.ndjson, "the journal of --ndjson", files);
  if (pictures.index) files.add_output(*pictures.index, "the index of --html");
  add_pictures(pictures.pages, "the page", inputs, files);
  add_pictures(pictures.fields, "the field", inputs, files);
  add_pictures(pictures.separations, "the separation", inputs, files);
}

}  // namespace meshalyzer
