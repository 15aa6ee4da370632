#include "check_options.h"

#include "usage_error.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace meshalyzer {
namespace {

constexpr const char* kOnlyVolume =
    "-v prints only the total volume: no other report can go with it";

bool attributes_only(const Options& options) {
  return options.mesh.scope == Scope::AttributesOnly;
}

bool names_by_threshold(const MeshRequest& mesh) {
  return mesh.shorter_than || mesh.longer_than || mesh.angle_below_degrees ||
         mesh.angle_above_degrees || mesh.aspect_above;
}

void check_meshes(const Options& options) {
  if (options.paths.empty()) {
    throw UsageError("no PATH: name a mesh file, a folder, or - for standard input");
  }
  if (std::count(options.paths.begin(), options.paths.end(), "-") > 1) {
    throw UsageError("standard input (-) can be read only once");
  }
  if (attributes_only(options) && options.mesh.goodness) {
    throw UsageError("-a and -g exclude each other");
  }
  if (attributes_only(options) && names_by_threshold(options.mesh)) {
    throw UsageError("-a measures nothing, so -b, -c, -d, -e and -f cannot go with it");
  }
  if (options.total_volume &&
      (attributes_only(options) || options.offenders != OffenderStyle::None ||
       options.mesh.goodness || options.json || names_by_threshold(options.mesh))) {
    throw UsageError(kOnlyVolume);
  }
}

/// Tells whether the distances between the meshes of a set are requested.
bool measures_separation(const Options& options) {
  return options.questions.separation || (!options.questions.any() && !options.total_volume &&
                                          !attributes_only(options) && !options.mesh.goodness);
}

void check_set(const Options& options) {
  if (options.total_volume && options.questions.any()) {
    throw UsageError("-v prints only the total volume: -i and -s cannot go with it");
  }
  if (const std::string_view option = option_of_separation(options);
      !option.empty() && !measures_separation(options)) {
    throw UsageError(std::string(option) + " needs -s");
  }
}

void check_journal(const Options& options) {
  const bool has_journal = options.ndjson || options.resume;
  if (has_journal && options.offenders == OffenderStyle::CustomPoints) {
    throw UsageError("-q prints positions, which the lines of --ndjson do not hold: use -p");
  }
  if (options.shard && (!has_journal || is_stdout(options.ndjson))) {
    throw UsageError("--shard needs --ndjson=FILE, for `meshalyzer merge` to make the report of");
  }
  if (options.shard && options.json) {
    throw UsageError("--shard does a part of the work: `meshalyzer merge --json` makes the report");
  }
  if (options.total_volume && (has_journal || options.summary)) {
    throw UsageError(kOnlyVolume);
  }
}

/// Checks the dependencies and exclusions of the options of curvatures and pictures.
void check_pictures(const Options& options) {
  const FieldExport& wanted = options.field_export;
  if (wanted.file.has_value() != wanted.field.has_value()) {
    throw UsageError("--export FILE and --field F need each other");
  }
  if (wanted.palette && !wanted.file) {
    throw UsageError("--palette needs --export");
  }
  const std::string_view measured = options.mesh.curvature ? "--curvature"
                                    : wanted.file          ? "--export"
                                    : options.html         ? "--html"
                                                           : "";
  if (measured.empty()) {
    return;
  }
  if (attributes_only(options)) {
    throw UsageError("-a measures nothing, so " + std::string(measured) + " cannot go with it");
  }
  if (options.total_volume) {
    throw UsageError(kOnlyVolume);
  }
  if (options.shard && options.html) {
    throw UsageError("--shard does a part of the work: --html shows the whole of it");
  }
}

}  // namespace

std::string_view option_of_separation(const Options& options) {
  return options.separation.search_radius                      ? "--search-radius"
         : options.separation.search_cone_degrees              ? "--search-cone"
         : options.separation.include_self                     ? "--include-self"
         : options.separation_ply                              ? "--separation-ply"
         : options.field_export.field == FieldName::Separation ? "--field separation"
         : options.force                                       ? "--force"
                                                               : "";
}

void check_reports(const Options& options) {
  const std::string_view in_place_of_text = is_stdout(options.json)     ? "--json"
                                            : is_stdout(options.ndjson) ? "--ndjson"
                                                                        : "";
  if (is_stdout(options.ndjson) && is_stdout(options.json)) {
    throw UsageError("--json and --ndjson cannot both go to standard output");
  }
  if (options.summary && !in_place_of_text.empty()) {
    throw UsageError("--summary and " + std::string(in_place_of_text) +
                     " cannot both go to standard output");
  }
}

void check_options(const Options& options) {
  check_meshes(options);
  check_set(options);
  check_reports(options);
  check_journal(options);
  check_pictures(options);
}

}  // namespace meshalyzer
