#include "options.h"

#include "arguments.h"
#include "help.h"
#include "meshalyzer/base/memory_size.h"
#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace meshalyzer {
namespace {

/// The options as they stand on the command line; numbers are still text, so that no locale reads
/// them.
struct Raw {
  std::vector<std::string> paths;
  bool attributes_only = false;
  std::string goodness;
  bool print = false;
  bool points = false;
  bool total_volume = false;
  std::string shorter, longer, angle_below, angle_above, aspect_above;
  bool exact_coincidence = false;
  std::string json;
  std::string threads;
  bool quiet = false;
  bool no_progress = false;
  bool version = false;
  bool intersections = false;
  bool separation = false;
  bool force = false;
  std::string search_radius, search_cone, include_self;
  std::string separation_ply;
  bool summary = false;
  std::string ndjson, resume, shard, memory_limit;
  std::string curvature, export_file, field, palette, html;
};

void declare_options(CLI::App& app, Raw& raw) {
  app.add_option("PATH", raw.paths);
  app.add_flag("-a", raw.attributes_only);
  app.add_option("-g", raw.goodness)->type_name("AR,ANGLE,LEN");
  app.add_flag("-v", raw.total_volume);
  app.add_flag("--exact-coincidence", raw.exact_coincidence);
  app.add_flag("-p", raw.print);
  app.add_flag("-q", raw.points);
  app.add_option("-b", raw.shorter)->type_name("N");
  app.add_option("-c", raw.longer)->type_name("N");
  app.add_option("-d", raw.angle_below)->type_name("N");
  app.add_option("-e", raw.angle_above)->type_name("N");
  app.add_option("-f", raw.aspect_above)->type_name("N");
  // A flag with a value, not an option: a PATH that follows must not be taken for its FILE.
  app.add_flag("--json{-}", raw.json);
  app.add_flag("--summary", raw.summary);
  app.add_option("--threads", raw.threads)->type_name("N");
  app.add_flag("--quiet", raw.quiet);
  app.add_flag("--no-progress", raw.no_progress);
  app.add_flag("--version", raw.version);
}

void declare_set_options(CLI::App& app, Raw& raw) {
  app.add_flag("-i", raw.intersections);
  app.add_flag("-s", raw.separation);
  app.add_option("--search-radius", raw.search_radius)->type_name("R");
  app.add_option("--search-cone", raw.search_cone)->type_name("DEG");
  app.add_option("--include-self", raw.include_self)->type_name("R");
  app.add_flag("--force", raw.force);
  app.add_option("--separation-ply", raw.separation_ply)->type_name("DIR");
  app.add_flag("--ndjson{-}", raw.ndjson);
  app.add_option("--resume", raw.resume)->type_name("FILE");
  app.add_option("--shard", raw.shard)->type_name("K/N");
  app.add_option("--memory-limit", raw.memory_limit)->type_name("SIZE");
}

void declare_picture_options(CLI::App& app, Raw& raw) {
  app.add_flag("--curvature{mixed}", raw.curvature);
  app.add_option("--export", raw.export_file)->type_name("FILE");
  app.add_option("--field", raw.field)->type_name("F");
  app.add_option("--palette", raw.palette)->type_name("NAME");
  app.add_option("--html", raw.html)->type_name("FILE");
}

std::optional<double> to_limit(const std::string& text, const std::string& option) {
  return text.empty() ? std::nullopt : std::optional(to_real(text, option));
}

/// @param text  "AR,ANGLE,LEN".
GoodnessThresholds to_thresholds(const std::string& text) {
  std::string_view rest = without_sign(text);
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> value = parse_real(rest.substr(0, comma));
    const bool is_last = comma == std::string_view::npos;
    if (!value || std::isnan(*value) || is_last != (i == 2)) {
      throw UsageError("-g needs three numbers AR,ANGLE,LEN, not '" + text + "'");
    }
    numbers[i] = *value;
    rest.remove_prefix(is_last ? rest.size() : comma + 1);
  }
  return {numbers[0], numbers[1], numbers[2]};
}

bool names_by_threshold(const Raw& raw) {
  return !(raw.shorter.empty() && raw.longer.empty() && raw.angle_below.empty() &&
           raw.angle_above.empty() && raw.aspect_above.empty());
}

/// What curvatures and pictures need, and do not go with.
void check_picture_options(const Raw& raw) {
  if (raw.export_file.empty() != raw.field.empty()) {
    throw UsageError("--export FILE and --field F need each other");
  }
  if (!raw.palette.empty() && raw.export_file.empty()) {
    throw UsageError("--palette needs --export");
  }
  const std::string_view asked = !raw.curvature.empty()     ? "--curvature"
                                 : !raw.export_file.empty() ? "--export"
                                 : !raw.html.empty()        ? "--html"
                                                            : "";
  if (asked.empty()) {
    return;
  }
  if (raw.attributes_only) {
    throw UsageError("-a measures nothing, so " + std::string(asked) + " cannot go with it");
  }
  if (raw.total_volume) {
    throw UsageError("-v prints only the total volume: no other report can go with it");
  }
  if (!raw.shard.empty() && !raw.html.empty()) {
    throw UsageError("--shard does a part of the work: --html shows the whole of it");
  }
}

/// Whether the distances between the meshes of a set are asked for.
bool measures_separation(const Raw& raw) {
  const bool has_set_work = raw.intersections || raw.separation;
  return raw.separation || (!has_set_work && !raw.attributes_only && raw.goodness.empty());
}

/// What the options of a set do not allow.
void check_set_options(const Raw& raw) {
  const bool has_set_work = raw.intersections || raw.separation;
  if (raw.total_volume && has_set_work) {
    throw UsageError("-v prints only the total volume: -i and -s cannot go with it");
  }
  const std::string_view needs_separation = !raw.search_radius.empty()    ? "--search-radius"
                                            : !raw.search_cone.empty()    ? "--search-cone"
                                            : !raw.include_self.empty()   ? "--include-self"
                                            : !raw.separation_ply.empty() ? "--separation-ply"
                                            : raw.field == "separation"   ? "--field separation"
                                            : raw.force                   ? "--force"
                                                                          : "";
  if (!needs_separation.empty() && !measures_separation(raw)) {
    throw UsageError(std::string(needs_separation) + " needs -s");
  }
  const bool has_journal = !raw.ndjson.empty() || !raw.resume.empty();
  if (has_journal && raw.points) {
    throw UsageError("-q prints positions, which the lines of --ndjson do not hold: use -p");
  }
  if (raw.ndjson == "-" && raw.json == "-") {
    throw UsageError("--json and --ndjson cannot both go to standard output");
  }
  if (!raw.shard.empty() && (!has_journal || raw.ndjson == "-")) {
    throw UsageError("--shard needs --ndjson=FILE, for `meshalyzer merge` to make the report of");
  }
  if (!raw.shard.empty() && !raw.json.empty()) {
    throw UsageError("--shard does a part of the work: `meshalyzer merge --json` makes the report");
  }
  if (raw.total_volume && (has_journal || raw.summary)) {
    throw UsageError("-v prints only the total volume: no other report can go with it");
  }
}

void check_consistent(const Raw& raw) {
  if (raw.paths.empty()) {
    throw UsageError("no PATH: name a mesh file, a folder, or - for standard input");
  }
  if (std::count(raw.paths.begin(), raw.paths.end(), "-") > 1) {
    throw UsageError("standard input (-) can be read only once");
  }
  if (raw.attributes_only && !raw.goodness.empty()) {
    throw UsageError("-a and -g exclude each other");
  }
  if (raw.attributes_only && names_by_threshold(raw)) {
    throw UsageError("-a measures nothing, so -b, -c, -d, -e and -f cannot go with it");
  }
  if (raw.total_volume && (raw.attributes_only || raw.print || raw.points ||
                           !raw.goodness.empty() || !raw.json.empty() || names_by_threshold(raw))) {
    throw UsageError("-v prints only the total volume: no other report can go with it");
  }
}

VertexArea to_area(const std::string& text) {
  const std::optional<VertexArea> area = vertex_area(text);
  if (!area) {
    throw UsageError("--curvature needs mixed, voronoi, barycentric or one-ring, not '" + text +
                     "'");
  }
  return *area;
}

/// The names of some values, "a, b, c".
template <typename Values, typename Name>
std::string names_of(const Values& values, const Name& name) {
  std::string text;
  for (const auto value : values) {
    text += (text.empty() ? "" : ", ") + std::string(name(value));
  }
  return text;
}

AnalysisOptions to_analysis_options(const Raw& raw) {
  AnalysisOptions options;
  // Volumes need no more than the attributes do.
  options.scope =
      raw.attributes_only || raw.total_volume ? Scope::AttributesOnly : Scope::Everything;
  if (!raw.goodness.empty()) {
    options.goodness = to_thresholds(raw.goodness);
  }
  options.shorter_than = to_limit(raw.shorter, "-b");
  options.longer_than = to_limit(raw.longer, "-c");
  options.angle_below_degrees = to_limit(raw.angle_below, "-d");
  options.angle_above_degrees = to_limit(raw.angle_above, "-e");
  options.aspect_above = to_limit(raw.aspect_above, "-f");
  options.exact_coincidence = raw.exact_coincidence;
  options.curvature = raw.curvature.empty() ? std::nullopt : std::optional(to_area(raw.curvature));
  options.keep_soup = raw.points || !raw.html.empty() || !raw.export_file.empty();
  return options;
}

/// What is asked of --export and --field.
std::optional<FieldExport> to_field_export(const Raw& raw) {
  if (raw.export_file.empty()) {
    return std::nullopt;
  }
  const std::optional<FieldName> field = field_of(raw.field);
  if (!field) {
    throw UsageError("--field needs one of " + names_of(all_field_names(), field_name) + ", not '" +
                     raw.field + "'");
  }
  FieldExport wanted{raw.export_file, *field};
  if (!raw.palette.empty()) {
    wanted.palette = palette_of(raw.palette);
    if (!wanted.palette) {
      throw UsageError("--palette needs viridis, diverging, jet or hot, not '" + raw.palette + "'");
    }
  }
  return wanted;
}

double to_cone(const std::string& text, const std::string& option) {
  const double degrees = to_real(text, option);
  if (!(degrees >= 0.0 && degrees <= 90.0)) {
    throw UsageError(option + " needs an angle from 0 to 90 degrees, not '" + text + "'");
  }
  return degrees;
}

SeparationOptions to_separation_options(const Raw& raw) {
  SeparationOptions options;
  if (!raw.search_radius.empty()) {
    options.search_radius = to_length(raw.search_radius, "--search-radius");
  }
  if (!raw.search_cone.empty()) {
    options.search_cone_degrees = to_cone(raw.search_cone, "--search-cone");
  }
  if (!raw.include_self.empty()) {
    options.include_self = to_length(raw.include_self, "--include-self");
  }
  return options;
}

/// @param text  "K/N", K from 1.
Shard to_shard(const std::string& text) {
  if (text.empty()) {
    return {};
  }
  const std::size_t slash = text.find('/');
  const std::optional<std::int64_t> k = parse_integer(text.substr(0, slash));
  const std::optional<std::int64_t> n =
      slash == std::string::npos ? std::nullopt : parse_integer(text.substr(slash + 1));
  if (!k || !n || *k < 1 || *k > *n) {
    throw UsageError("--shard needs K/N, the number of the part and of all parts, not '" + text +
                     "'");
  }
  return {static_cast<std::size_t>(*k - 1), static_cast<std::size_t>(*n)};
}

std::uint64_t to_memory_limit(const std::string& text) {
  if (text.empty()) {
    return physical_memory() / 2;
  }
  const std::optional<std::uint64_t> bytes = parse_memory_size(text);
  if (!bytes) {
    throw UsageError("--memory-limit needs a size such as 500M or 4G, not '" + text + "'");
  }
  return *bytes;
}

std::string to_asked_text(const Raw& raw) {
  std::string text;
  const auto word = [&](std::string_view option, bool is_there) {
    if (is_there) {
      text += (text.empty() ? "" : " ") + std::string(option);
    }
  };
  const auto value = [&](const std::string& option, const std::string& given) {
    word(option + "=" + std::string(without_sign(given)), !given.empty());
  };
  word("-a", raw.attributes_only);
  value("-g", raw.goodness);
  word("-v", raw.total_volume);
  word("--exact-coincidence", raw.exact_coincidence);
  word("-p", raw.print);
  value("-b", raw.shorter);
  value("-c", raw.longer);
  value("-d", raw.angle_below);
  value("-e", raw.angle_above);
  value("-f", raw.aspect_above);
  value("--curvature", raw.curvature);
  word("-i", raw.intersections);
  word("-s", raw.separation);
  word("--force", raw.force);
  value("--search-radius", raw.search_radius);
  value("--search-cone", raw.search_cone);
  value("--include-self", raw.include_self);
  return text;
}

Options to_options(const Raw& raw) {
  check_consistent(raw);
  check_set_options(raw);
  check_picture_options(raw);
  Options options;
  options.paths = raw.paths;
  options.analysis = to_analysis_options(raw);
  options.offenders = raw.points  ? OffenderStyle::CustomPoints
                      : raw.print ? OffenderStyle::Ids
                                  : OffenderStyle::None;
  options.show = raw.total_volume ? Show::TotalVolume : raw.summary ? Show::Summary : Show::Report;
  options.asked = {raw.intersections, raw.separation};
  options.separation = to_separation_options(raw);
  options.force = raw.force;
  const auto target = [](const std::string& file) {
    return file.empty() ? std::nullopt : std::optional(ReportTarget{file});
  };
  options.json = target(raw.json);
  options.resume = raw.resume.empty() ? std::nullopt : std::optional(raw.resume);
  options.ndjson = target(raw.ndjson.empty() ? raw.resume : raw.ndjson);
  options.separation_ply =
      raw.separation_ply.empty() ? std::nullopt : std::optional(raw.separation_ply);
  options.field_export = to_field_export(raw);
  options.html = raw.html.empty() ? std::nullopt : std::optional(raw.html);
  options.shard = to_shard(raw.shard);
  options.memory_limit = to_memory_limit(raw.memory_limit);
  options.asked_text = to_asked_text(raw);
  options.threads = to_thread_count(raw.threads);
  options.progress =
      raw.quiet || raw.no_progress ? Options::Progress::Never : Options::Progress::OnTerminal;
  return options;
}

}  // namespace

SetQuestions questions_of(const Options& options) {
  const bool all = !options.asked.any() && tells_totals(options);
  SetQuestions questions;
  questions.intersections = all || options.asked.intersections;
  if (all || options.asked.separation) {
    questions.separation = options.separation;
  }
  questions.force = options.force;
  return questions;
}

bool tells_totals(const Options& options) {
  return options.analysis.scope == Scope::Everything && !options.analysis.goodness;
}

JsonOffenders json_offenders(const Options& options) {
  return options.offenders == OffenderStyle::None ? JsonOffenders::Omit : JsonOffenders::List;
}

CommandLine parse_command_line(int argc, const char* const* argv) {
  Raw raw;
  CLI::App app;
  declare_options(app, raw);
  declare_set_options(app, raw);
  declare_picture_options(app, raw);
  try {
    parse_arguments(app, argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {{}, std::string(help_text())};
  }
  if (raw.version) {
    return {{}, "meshalyzer " MESHALYZER_VERSION "\n"};
  }
  return {to_options(raw), std::nullopt};
}

}  // namespace meshalyzer
