#include "changed_line.h"
#include "check_parser.h"
#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/report/text/mesh_report.h"

namespace {

using namespace meshalyzer;

std::string line_of(const Analysis& analysis) {
  JsonWriter json;
  json.begin_object(JsonLayout::Row);
  write_mesh_members(json, analysis, JsonOffenders::List);
  json.end_object();
  return json.take();
}

/// Three faces on one edge, a face apart, an orphan, a repeated id: something in most lists.
std::string line_of_bad_mesh() {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {5, 5, 5}, {5, 5, 6}};
  soup.vertex_ids.named = {1, 2, 3, 4, 6, 7, 7};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {2, 3, 5}, {0, 0, 1}};
  AnalysisOptions options;
  options.longer_than = 1.0;
  options.angle_below_degrees = 360.0;
  options.aspect_above = 1.0;
  return line_of(analyze(std::move(soup), "bad.mesh", options));
}

/// Any text is either refused by an InvalidArgument or makes an analysis that the reports can show,
/// and that its own line keeps.
void check(std::string_view text) {
  Analysis analysis;
  try {
    analysis = read_mesh_members(text);
  } catch (const InvalidArgument&) {
    return;
  }
  const std::string line = line_of(analysis);
  const Analysis again = read_mesh_members(line);
  const bool is_kept = line_of(again) == line && text_report(again, OffenderStyle::Ids) ==
                                                     text_report(analysis, OffenderStyle::Ids);
  if (!is_kept) {
    std::abort();
  }
}

}  // namespace

/// The bytes are tried as a line, and then as changes to a good one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string good = line_of_bad_mesh();
  check(as_text(data, size));
  check(changed_line(good, data, size));
  return 0;
}
