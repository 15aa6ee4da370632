#include "options.h"

#include "help.h"
#include "meshalyzer/base/numbers.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meshalyzer {
namespace {

constexpr std::size_t kMaxThreads = 1024;

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
  std::string curvature, export_file, field, html;
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
  app.add_option("--threads", raw.threads)->type_name("N");
  app.add_flag("--quiet", raw.quiet);
  app.add_flag("--no-progress", raw.no_progress);
  app.add_flag("--version", raw.version);
}

/// Options of later versions: known, so that they can be refused by name.
void declare_future_options(CLI::App& app, Raw& raw) {
  app.add_flag("-i", raw.intersections);
  app.add_flag("-s", raw.separation);
  app.add_flag("--curvature{mixed}", raw.curvature);
  app.add_option("--export", raw.export_file)->type_name("FILE");
  app.add_option("--field", raw.field)->type_name("F");
  app.add_option("--html", raw.html)->type_name("FILE");
}

/// The parser leaves the sign of `-g=...` in the value.
std::string_view without_sign(std::string_view text) {
  text.remove_prefix(text.starts_with('=') ? 1 : 0);
  return text;
}

/// The option that a message of the parser begins with.
std::string upto_colon(std::string_view message) {
  return std::string(message.substr(0, message.find(':')));
}

/// Below, an empty text stands for an option that is absent.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.empty()) {
        throw UsageError(option->get_name() + " needs a value, not an empty text");
      }
    }
  }
}

double to_real(const std::string& text, const std::string& option) {
  const std::optional<double> value = parse_real(without_sign(text));
  if (!value || std::isnan(*value)) {
    throw UsageError(option + " needs a number, not '" + text + "'");
  }
  return *value;
}

std::optional<double> to_limit(const std::string& text, const std::string& option) {
  return text.empty() ? std::nullopt : std::optional(to_real(text, option));
}

std::size_t to_thread_count(const std::string& text) {
  if (text.empty()) {
    return 0;
  }
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value || *value < 0 || *value > static_cast<std::int64_t>(kMaxThreads)) {
    throw UsageError("--threads needs a whole number from 0 to " + std::to_string(kMaxThreads) +
                     ", not '" + text + "'");
  }
  return static_cast<std::size_t>(*value);
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

void check_available(const Raw& raw) {
  const std::string_view missing = raw.intersections          ? "-i"
                                   : raw.separation           ? "-s"
                                   : !raw.curvature.empty()   ? "--curvature"
                                   : !raw.export_file.empty() ? "--export"
                                   : !raw.field.empty()       ? "--field"
                                   : !raw.html.empty()        ? "--html"
                                                              : "";
  if (!missing.empty()) {
    throw UsageError(std::string(missing) +
                     " is not available yet in this version (" MESHALYZER_VERSION ")");
  }
}

bool names_by_threshold(const Raw& raw) {
  return !(raw.shorter.empty() && raw.longer.empty() && raw.angle_below.empty() &&
           raw.angle_above.empty() && raw.aspect_above.empty());
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

AnalysisOptions to_analysis_options(const Raw& raw) {
  AnalysisOptions options;
  options.scope = raw.attributes_only ? Scope::AttributesOnly : Scope::Everything;
  if (!raw.goodness.empty()) {
    options.goodness = to_thresholds(raw.goodness);
  }
  options.shorter_than = to_limit(raw.shorter, "-b");
  options.longer_than = to_limit(raw.longer, "-c");
  options.angle_below_degrees = to_limit(raw.angle_below, "-d");
  options.angle_above_degrees = to_limit(raw.angle_above, "-e");
  options.aspect_above = to_limit(raw.aspect_above, "-f");
  options.exact_coincidence = raw.exact_coincidence;
  options.keep_geometry = raw.points;
  return options;
}

Options to_options(const Raw& raw) {
  check_consistent(raw);
  Options options;
  options.paths = raw.paths;
  options.analysis = to_analysis_options(raw);
  options.offenders = raw.points  ? OffenderStyle::CustomPoints
                      : raw.print ? OffenderStyle::Ids
                                  : OffenderStyle::None;
  options.show = raw.total_volume ? Show::TotalVolume : Show::Report;
  if (!raw.json.empty()) {
    options.json = JsonTarget{raw.json};
  }
  options.threads = to_thread_count(raw.threads);
  options.progress =
      raw.quiet || raw.no_progress ? Options::Progress::Never : Options::Progress::OnTerminal;
  check_available(raw);
  return options;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  Raw raw;
  CLI::App app;
  declare_options(app, raw);
  declare_future_options(app, raw);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {{}, std::string(help_text())};
  } catch (const CLI::ArgumentMismatch& error) {
    throw UsageError(upto_colon(error.what()) + " must be given once, with one value");
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  refuse_empty_values(app);
  if (raw.version) {
    return {{}, "meshalyzer " MESHALYZER_VERSION "\n"};
  }
  return {to_options(raw), std::nullopt};
}

}  // namespace meshalyzer
