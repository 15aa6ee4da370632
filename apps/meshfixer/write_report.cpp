#include "write_report.h"

#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/writer.h"

#include <ostream>

namespace meshalyzer::fixer {

void write_reason_of_no_report(const Options& options, Streams streams, const std::string& reason) {
  if (!options.json) return;
  JsonWriter json;
  json.begin_object();
  json.member("schema", "meshfixer-error/1");
  json.member("version", MESHALYZER_VERSION);
  write_bytes(json, "error", reason);
  json.end_object();
  if (options.json->is_stdout()) {
    streams.out << json.take() << std::flush;
  } else {
    replace_file(options.json->file, json.take());
  }
}

}  // namespace meshalyzer::fixer
