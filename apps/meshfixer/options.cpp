#include "options.h"

#include "arguments.h"
#include "file_ending.h"
#include "help.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/format_of.h"
#include "usage_error.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

/// The options as they stand on the command line.
struct Raw {
  std::vector<std::string> paths;
  std::string output;
  bool find = false, dry_run = false;
  std::string fix, no_fix;
  std::string weld;
  bool flip = false, renumber = false, drop_orphans = false;
  bool separate = false;
  std::string keep_largest;
  bool keep_borders = false, by_group = false, keep_contact = false;
  std::string fill_holes, fill_at, fill_shape;
  std::string max_deviation;
  std::string tolerance, degeneracy, slit, height, foldover_angle;
  bool print = false;
  std::string max_defects, json, threads;
  bool quiet = false, no_progress = false, version = false;
  bool guarantee = false;
  std::string html;

  /// Whether holes are asked for by name, beside --fix.
  [[nodiscard]] bool names_holes() const {
    return !fill_holes.empty() || !fill_at.empty() || !fill_shape.empty();
  }
  [[nodiscard]] bool names_operation() const {
    return !weld.empty() || flip || renumber || drop_orphans;
  }
  [[nodiscard]] bool changes_by_name() const {
    return names_operation() || separate || !keep_largest.empty();
  }
};

void declare_actions(CLI::App& app, Raw& raw) {
  app.add_option("IN", raw.paths);
  app.add_option("-o", raw.output)->type_name("OUT");
  app.add_flag("--find", raw.find);
  app.add_flag("--dry-run", raw.dry_run);
  app.add_option("--fix", raw.fix)->type_name("LIST");
  app.add_option("--no-fix", raw.no_fix)->type_name("LIST");
  app.add_option("--weld", raw.weld)->type_name("TOL");
  app.add_flag("--flip", raw.flip);
  app.add_flag("--renumber", raw.renumber);
  app.add_flag("--drop-orphans", raw.drop_orphans);
  app.add_flag("--separate", raw.separate);
  app.add_option("--keep-largest", raw.keep_largest)->type_name("N");
  app.add_flag("--keep-borders", raw.keep_borders);
  app.add_flag("--by-group", raw.by_group);
  app.add_flag("--keep-contact", raw.keep_contact);
  app.add_option("--fill-holes", raw.fill_holes)->type_name("N");
  app.add_option("--fill-at", raw.fill_at)->type_name("X,Y,Z");
  app.add_option("--fill-shape", raw.fill_shape)->type_name("SHAPE");
  app.add_flag("--guarantee", raw.guarantee);
}

void declare_limits_and_reports(CLI::App& app, Raw& raw) {
  app.add_option("--max-deviation", raw.max_deviation)->type_name("D");
  app.add_option("--tolerance", raw.tolerance)->type_name("T");
  app.add_option("--degen-tolerance", raw.degeneracy)->type_name("T");
  app.add_option("--slit-tolerance", raw.slit)->type_name("T");
  app.add_option("--height-tolerance", raw.height)->type_name("T");
  app.add_option("--max-foldover-angle", raw.foldover_angle)->type_name("DEG");
  app.add_flag("-p", raw.print);
  app.add_option("--max-defects", raw.max_defects)->type_name("N");
  // A flag with a value, not an option: an IN that follows must not be taken for its FILE.
  app.add_flag("--json{-}", raw.json);
  app.add_option("--html", raw.html)->type_name("FILE");
  app.add_option("--threads", raw.threads)->type_name("N");
  app.add_flag("--quiet", raw.quiet);
  app.add_flag("--no-progress", raw.no_progress);
  app.add_flag("--version", raw.version);
}

void check_consistent(const Raw& raw) {
  if (raw.guarantee) throw UsageError("--guarantee is not available yet in this version");
  if (raw.paths.empty()) throw UsageError("no IN: name a mesh file, or - for standard input");
  if (raw.paths.size() > 1) {
    throw UsageError("one mesh at a time: " + raw.paths[1] + " is one too many");
  }
  if (raw.find && (!raw.output.empty() || raw.dry_run || raw.changes_by_name())) {
    throw UsageError("--find only reports: no option that changes or writes a mesh can go with it");
  }
  if (raw.dry_run && !raw.output.empty()) {
    throw UsageError("--dry-run writes nothing, so -o cannot go with it");
  }
  if (!raw.find && !raw.dry_run && raw.output.empty()) {
    throw UsageError("no OUT: name it with -o, or ask for --find or --dry-run");
  }
  if (raw.keep_borders && raw.names_holes()) {
    throw UsageError("--keep-borders fills no hole, so no --fill- option can go with it");
  }
  if (!raw.output.empty() && !format_of_name(raw.output)) {
    throw UsageError("'" + raw.output + "' has the ending of no known mesh format");
  }
}

/// Calls `use` for each item of a list with commas.
void for_each_item(std::string_view list, const std::function<void(std::string_view)>& use) {
  while (true) {
    const std::size_t comma = list.find(',');
    use(list.substr(0, comma));
    if (comma == std::string_view::npos) return;
    list.remove_prefix(comma + 1);
  }
}

DefectCodes to_codes(const std::string& list, const std::string& option) {
  DefectCodes codes;
  for_each_item(list, [&](std::string_view item) {
    const std::optional<DefectCode> one = defect_code(item);
    if (one) {
      codes.insert(*one);
    } else if (item == "all" || item == "default") {
      const DefectCodes more = item == "all" ? DefectCodes::all() : default_fixes();
      for (const DefectCode code : all_defect_codes()) {
        if (more.contains(code)) codes.insert(code);
      }
    } else {
      throw UsageError(option + " needs defect codes, not '" + std::string(item) + "'");
    }
  });
  return codes;
}

/// What is to be fixed: what --fix says, else nothing where only single operations are named, else
/// the default; and what options ask for that go by the name of a defect.
DefectCodes to_fixes(const Raw& raw) {
  DefectCodes fixes = default_fixes();
  if (!raw.fix.empty()) {
    fixes = to_codes(raw.fix, "--fix");
  } else if (raw.names_operation() && raw.no_fix.empty()) {
    fixes = {};
  }
  if (!raw.no_fix.empty()) {
    const DefectCodes but = to_codes(raw.no_fix, "--no-fix");
    for (const DefectCode code : all_defect_codes()) {
      if (but.contains(code)) fixes.erase(code);
    }
  }
  if (raw.names_holes()) fixes.insert(DefectCode::Hole);
  if (raw.renumber) fixes.insert(DefectCode::Numbering);
  if (raw.drop_orphans) fixes.insert(DefectCode::OrphanVertex);
  if (raw.separate) fixes.insert(DefectCode::Disjoint);
  if (raw.keep_borders) fixes.erase(DefectCode::Hole);
  return fixes;
}

std::size_t to_count(const std::string& text, const std::string& option, std::int64_t least) {
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value || *value < least) {
    throw UsageError(option + " needs a whole number from " + std::to_string(least) + ", not '" +
                     text + "'");
  }
  return static_cast<std::size_t>(*value);
}

Vec3 to_point(const std::string& text) {
  std::vector<double> numbers;
  for_each_item(text, [&](std::string_view item) {
    const std::optional<double> value = parse_real(item);
    if (!value) throw UsageError("--fill-at needs a point X,Y,Z, not '" + text + "'");
    numbers.push_back(*value);
  });
  if (numbers.size() != 3) throw UsageError("--fill-at needs a point X,Y,Z, not '" + text + "'");
  return {numbers[0], numbers[1], numbers[2]};
}

FillOptions to_fill(const Raw& raw) {
  FillOptions fill;
  if (!raw.fill_holes.empty()) fill.max_edges = to_count(raw.fill_holes, "--fill-holes", 0);
  if (!raw.fill_at.empty()) fill.at = to_point(raw.fill_at);
  if (raw.fill_shape == "smooth") {
    fill.shape = FillShape::Smooth;
  } else if (!raw.fill_shape.empty() && raw.fill_shape != "linear") {
    throw UsageError("--fill-shape needs linear or smooth, not '" + raw.fill_shape + "'");
  }
  const bool is_named =
      raw.names_holes() ||
      (!raw.fix.empty() && to_codes(raw.fix, "--fix").contains(DefectCode::Hole) &&
       raw.fix != "all" && raw.fix != "default");
  fill.sheets = is_named ? FillSheets::Yes : FillSheets::No;
  return fill;
}

/// @param text  A length, or a share of the diagonal as in "0.1%".
Deviation to_deviation(const std::string& text) {
  if (text.empty()) return {};
  if (text.back() == '%') {
    const std::string number = text.substr(0, text.size() - 1);
    return {to_length(number, "--max-deviation") / 100.0, Deviation::Unit::Diagonal};
  }
  return {to_length(text, "--max-deviation"), Deviation::Unit::Length};
}

ToleranceOptions to_tolerances(const Raw& raw) {
  const auto length = [](const std::string& text, const std::string& option) {
    return text.empty() ? std::nullopt : std::optional(to_length(text, option));
  };
  ToleranceOptions tolerances;
  tolerances.tolerance = length(raw.tolerance, "--tolerance");
  tolerances.degeneracy = length(raw.degeneracy, "--degen-tolerance");
  tolerances.slit = length(raw.slit, "--slit-tolerance");
  tolerances.height = length(raw.height, "--height-tolerance");
  if (!raw.foldover_angle.empty()) {
    tolerances.max_foldover_angle = to_real(raw.foldover_angle, "--max-foldover-angle");
    if (!(tolerances.max_foldover_angle >= 0.0 && tolerances.max_foldover_angle <= 180.0)) {
      throw UsageError("--max-foldover-angle needs an angle from 0 to 180 degrees, not '" +
                       raw.foldover_angle + "'");
    }
  }
  return tolerances;
}

RepairOptions to_repair(const Raw& raw) {
  RepairOptions repair;
  repair.fixes = to_fixes(raw);
  repair.tolerances = to_tolerances(raw);
  repair.max_deviation = to_deviation(raw.max_deviation);
  repair.fill = to_fill(raw);
  if (!raw.weld.empty()) repair.weld_within = to_length(raw.weld, "--weld");
  repair.turn = raw.flip ? Turn::Everything : Turn::Nothing;
  repair.contact = raw.keep_contact ? Contact::Keep : Contact::Part;
  repair.borders = raw.keep_borders ? Borders::Meant : Borders::Holes;
  repair.groups = raw.by_group ? Groups::Faces : Groups::Names;
  if (!raw.keep_largest.empty()) {
    repair.keep_largest = to_count(raw.keep_largest, "--keep-largest", 1);
  }
  if (!raw.max_defects.empty()) {
    repair.max_defects = to_count(raw.max_defects, "--max-defects", 0);
  }
  return repair;
}

Options to_options(const Raw& raw) {
  check_consistent(raw);
  Options options;
  options.input = raw.paths.front();
  options.action = raw.find ? Options::Action::Find : Options::Action::Fix;
  if (!raw.output.empty()) options.output = raw.output;
  options.repair = to_repair(raw);
  options.lists = raw.print ? ListLength::Full : ListLength::Short;
  if (!raw.json.empty()) options.json = ReportTarget{raw.json};
  if (!raw.html.empty()) {
    static_cast<void>(require_ending(raw.html, "--html", {".html", ".htm"}));
    options.html = raw.html;
  }
  options.threads = to_thread_count(raw.threads);
  options.progress =
      raw.quiet || raw.no_progress ? Options::Progress::Never : Options::Progress::OnTerminal;
  return options;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  Raw raw;
  CLI::App app;
  declare_actions(app, raw);
  declare_limits_and_reports(app, raw);
  try {
    parse_arguments(app, argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {{}, std::string(help_text())};
  }
  if (raw.version) return {{}, "meshfixer " MESHALYZER_VERSION "\n"};
  return {to_options(raw), std::nullopt};
}

}  // namespace meshalyzer::fixer
