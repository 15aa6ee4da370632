#include "outputs.h"

#include "json_output.h"
#include "pictures.h"
#include "summary_output.h"
#include "text_output.h"
#include "volume_output.h"

namespace meshalyzer {
namespace {

/// Returns the output for a person on standard output, or null if something else goes there.
std::unique_ptr<Output> output_for_person(const Run& run, Streams streams) {
  if (is_stdout(run.options.json) || is_stdout(run.options.ndjson)) {
    return nullptr;
  }
  if (run.options.total_volume) {
    return std::make_unique<VolumeOutput>(streams);
  }
  if (run.options.summary) {
    return std::make_unique<SummaryOutput>(run, streams.out);
  }
  return std::make_unique<TextOutput>(run, streams.out);
}

}  // namespace

std::vector<std::unique_ptr<Output>> outputs_of(const Run& run, Streams streams) {
  std::vector<std::unique_ptr<Output>> outputs;
  if (run.options.json) {
    outputs.push_back(std::make_unique<JsonOutput>(run, streams.out));
  }
  if (draws_pictures(run.options)) {
    outputs.push_back(std::make_unique<Pictures>(run));
  }
  if (std::unique_ptr<Output> for_person = output_for_person(run, streams)) {
    outputs.push_back(std::move(for_person));
  }
  return outputs;
}

}  // namespace meshalyzer
