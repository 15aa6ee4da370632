#include "options.h"

#include "arguments.h"
#include "meshalyzer/base/numbers.h"
#include "values.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

/// The options whose meaning depends on the rest of the command line.
struct GivenOptions {
  std::vector<std::string> paths;
  bool find = false, dry_run = false;
  std::optional<CodeList> fix, no_fix;
  bool renumber = false, drop_orphans = false, separate = false;
  /// The last option for holes, other than --fix, and the last one for tolerances; empty if there
  /// is none.
  std::string hole_option, tolerance_option;
  std::vector<BooleanOperation> operations;
};

bool names_holes(const GivenOptions& given) {
  return !given.hole_option.empty();
}

/// Returns the codes that a list names; none if it is not given.
DefectCodes named_by(const std::optional<CodeList>& list) {
  return list ? list->named : DefectCodes{};
}

bool names_operation(const GivenOptions& given, const RepairOptions& repair) {
  return repair.weld_within || repair.turn == Turn::Everything || given.renumber ||
         given.drop_orphans;
}

void declare_actions(OptionTable& table, Options& options, GivenOptions& given) {
  table.group("Tasks");
  table.option("-o,--output OUT", into(options.output, to_output),
               "write the repaired mesh to OUT: a mesh file, or - for standard output (the "
               "report then goes to standard error), or a folder, for any number of meshes; a "
               "name without an ending is that of a folder, and so is one that ends with /");
  table.flag(
      "--in-place", [&options] { options.target = Options::Target::InPlace; },
      "write over the inputs: each stays as it was until its new file is complete, and also if "
      "nothing is changed");
  table.flag(
      "--backup", [&options] { options.backup = Options::Backup::Original; },
      "with --in-place: keep each file that is written over as FILE.orig");
  table.flag("--find", given.find,
             "only report the defects; of these, --fix and --no-fix say which count for the exit "
             "status");
  table.flag("--dry-run", given.dry_run, "repair and report, but write nothing");
  table.flag(
      "--strict-attributes", [&options] { options.loss = Options::Loss::Refuse; },
      "write nothing, with exit status 1, if OUT cannot hold all attributes of IN, such as "
      "texture coordinates; of several files the others are written");
  table.option("--fix LIST", into(given.fix, to_codes),
               "fix only these defects, by code: " + names_of(all_defect_codes(), defect_name) +
                   "; or default (all but disjoint and numbering), or all");
  table.option("--no-fix LIST", into(given.no_fix, to_codes), "do not fix these");
  table.flag(
      "--solid", options.repair.solid,
      "make the result a solid: fill holes of sheets too, and drop open fragments that "
      "enclose nothing and walls that divide the solid and are stored once, each reported with "
      "its area");
  table.flag("--guarantee", options.repair.guarantee,
             "replace the parts that are not good in the end by a new surface within the maximum "
             "deviation, or report that none was found; with --solid, sheets become thin solids "
             "if there is nothing else");
}

void declare_operations(OptionTable& table, Options& options, GivenOptions& given) {
  RepairOptions& repair = options.repair;
  table.option("--weld TOL", into(repair.weld_within, to_length),
               "join borders whose ends are within TOL");
  table.flag(
      "--flip", [&repair] { repair.turn = Turn::Everything; }, "turn every face over");
  table.flag("--renumber", given.renumber, "number vertices and faces 1, 2, ..., n");
  table.flag("--drop-orphans", given.drop_orphans,
             "drop vertices that no face uses. If nothing else is asked for, only these four are "
             "done; --solid and --guarantee ask for the default repairs too");
  table.flag("--separate", given.separate,
             "write one file for each component: OUT_1, OUT_2, ..., largest first; fixing "
             "disjoint does the same, as with --fix all");
  table.option("--keep-largest N", into(repair.keep_largest, to_count_from_one),
               "keep only the N components with most faces");
}

void declare_booleans(OptionTable& table, GivenOptions& given) {
  table.group("Several solids, combined exactly");
  const auto declare = [&](const char* name, BooleanOperation operation, const char* text) {
    table.flag(
        name, [&given, operation] { given.operations.push_back(operation); }, text);
  };
  declare("--union", BooleanOperation::Union,
          "the solid inside any input; the components of a single input are combined");
  declare("--intersection", BooleanOperation::Intersection, "the solid inside all inputs");
  declare("--difference", BooleanOperation::Difference,
          "the solid inside the first input and no other one");
  declare("--subtract-in-order", BooleanOperation::SubtractInOrder,
          "each input without those before it, written to files in the folder OUT; they are "
          "moved apart where they would touch");
}

/// Returns a function that takes a value of an option and keeps the name of the option.
OptionTable::Take noting(std::string& name, OptionTable::Take take) {
  return [&name, take = std::move(take)](const std::string& text, const std::string& option) {
    name = option;
    take(text, option);
  };
}

void declare_holes(OptionTable& table, Options& options, GivenOptions& given) {
  RepairOptions& repair = options.repair;
  FillOptions& fill = repair.fill;
  table.flag(
      "--keep-borders", [&repair] { repair.borders = Borders::Intended; },
      "borders are intended: no hole is filled, and border vertices stay where they are");
  table.flag(
      "--by-group", [&repair] { repair.groups = Groups::Faces; },
      "the groups of the file are faces of a body: their common borders keep every vertex and "
      "edge");
  table.option("--fill-holes N", noting(given.hole_option, into(fill.max_edges, to_count)),
               "fill loops of at most N edges");
  table.option("--fill-at X,Y,Z", noting(given.hole_option, into(fill.at, to_point)),
               "fill only the loop that is nearest to this point");
  table.option(
      "--fill-shape SHAPE", noting(given.hole_option, into(fill.shape, to_fill_shape)),
      "linear (no new vertices), smooth (refined and faired), or auto (the default): smooth "
      "where the surface bends towards the hole. With any of these three options, or where --fix "
      "names hole, holes of sheets (surfaces that bound no solid) are filled too");
  table.flag(
      "--keep-contact", [&repair] { repair.contact = Contact::Keep; },
      "copies of a vertex that was split stay in one place");
}

/// Returns the text of a default value: "1e-8", "0.1".
std::string default_text(double value) {
  std::string text = shortest(value);
  if (const std::size_t exponent = text.find("e-0"); exponent != std::string::npos) {
    text.erase(exponent + 2, 1);
  }
  return text;
}

void declare_limits(OptionTable& table, Options& options, GivenOptions& given) {
  RepairOptions& repair = options.repair;
  std::string& named = given.tolerance_option;
  ToleranceOptions& tolerances = repair.tolerances;
  table.group("Limits");
  table.option("--max-deviation D", into(repair.max_deviation, to_deviation),
               "no point of the old surface ends up farther than D from the new one, and outside "
               "of hole patches none of the new one from the old; D is a length, or a share of "
               "the diagonal as in " +
                   default_text(repair.max_deviation.value * 100.0) + "%, the default");
  table.option("--tolerance T", noting(named, into(tolerances.tolerance, to_length)),
               "all three tolerances below; default " + default_text(kDefaultTolerance) +
                   " of the diagonal");
  table.option("--degen-tolerance T", noting(named, into(tolerances.degeneracy, to_length)),
               "edges and altitudes below it are degenerate");
  table.option("--slit-tolerance T", noting(named, into(tolerances.slit, to_length)),
               "border edges within it are at one place");
  table.option("--height-tolerance T", noting(named, into(tolerances.height, to_length)),
               "a foldover is within it of the surface that it lies on");
  table.option(
      "--max-foldover-angle DEG",
      noting(named, into(tolerances.max_foldover_angle, to_foldover_angle)),
      "the largest angle of a fold; default " + default_text(tolerances.max_foldover_angle));
  table.option("--time-limit S", into(options.time_limit, to_seconds),
               "after S seconds write the mesh as repaired so far, checked, and report the "
               "defects that remain; Ctrl-C does the same, and a second one aborts");
}

void declare_reports(OptionTable& table, Options& options) {
  table.group("Reports");
  table.flag(
      "-p", [&options] { options.lists = ListLength::Full; },
      "name every element and every change, and the remaining defects that were not to be fixed");
  table.option("--max-defects N", into(options.repair.max_defects, to_count),
               "list at most N defects; 0, the default, lists all");
  declare_json(table, options);
  table.option_or("-", "--ndjson[=FILE]", into(options.ndjson),
                  "for many files: a line of JSON for each as soon as it is done, in place of "
                  "text; with FILE the lines go there, beside text");
  table.option("--html FILE", into(options.html, to_page),
               "the report as one page that opens in any browser, offline, with a 3D view before "
               "and after, every defect in a list and shown in place");
  declare_conduct(table, options);
}

/// Checks the options of the output: several meshes, and those written in place, have one report.
void check_target(const GivenOptions& given, const Options& options) {
  const bool is_in_place = options.target == Options::Target::InPlace;
  if (is_in_place && options.output) {
    throw UsageError("--in-place writes over the inputs, so -o cannot go with it");
  }
  if (options.backup == Options::Backup::Original && !is_in_place) {
    throw UsageError("--backup keeps what --in-place writes over, and needs it");
  }
  if (options.ndjson && !options.is_batch()) {
    throw UsageError("--ndjson tells of many files: it needs a folder as OUT, or --in-place");
  }
  if (is_stdout(options.ndjson) && is_stdout(options.json)) {
    throw UsageError("--json and --ndjson cannot both go to standard output");
  }
  if (is_in_place && (given.find || given.dry_run)) {
    throw UsageError("--find and --dry-run write nothing, so --in-place cannot go with them");
  }
  if (options.html && options.is_batch()) {
    throw UsageError("--html makes a page of one mesh");
  }
}

/// Returns the name of the first option that is given; empty if none is.
std::string first_given(std::initializer_list<std::pair<bool, const char*>> options) {
  for (const auto& [is_given, name] : options) {
    if (is_given) return name;
  }
  return {};
}

/// Names the first option that requests a repair, or a report that only a repair has; empty if
/// there is none.
std::string repair_option(const GivenOptions& given, const Options& options) {
  const RepairOptions& repair = options.repair;
  return first_given({{given.find, "--find"},
                      {given.fix.has_value(), "--fix"},
                      {given.no_fix.has_value(), "--no-fix"},
                      {repair.solid, "--solid"},
                      {repair.guarantee, "--guarantee"},
                      {options.target == Options::Target::InPlace, "--in-place"},
                      {options.backup == Options::Backup::Original, "--backup"},
                      {repair.weld_within.has_value(), "--weld"},
                      {repair.turn == Turn::Everything, "--flip"},
                      {given.renumber, "--renumber"},
                      {given.drop_orphans, "--drop-orphans"},
                      {given.separate, "--separate"},
                      {repair.keep_largest != 0, "--keep-largest"},
                      {repair.borders == Borders::Intended, "--keep-borders"},
                      {repair.groups == Groups::Faces, "--by-group"},
                      {repair.contact == Contact::Keep, "--keep-contact"},
                      {names_holes(given), given.hole_option.c_str()},
                      {!given.tolerance_option.empty(), given.tolerance_option.c_str()},
                      {options.lists == ListLength::Full, "-p"},
                      {repair.max_defects != 0, "--max-defects"},
                      {options.ndjson.has_value(), "--ndjson"}});
}

/// Names the first option that changes or writes a mesh by itself; empty if there is none.
std::string writing_option(const GivenOptions& given, const Options& options) {
  return first_given({{options.output.has_value(), "-o"},
                      {given.dry_run, "--dry-run"},
                      {options.repair.weld_within.has_value(), "--weld"},
                      {options.repair.turn == Turn::Everything, "--flip"},
                      {given.renumber, "--renumber"},
                      {given.drop_orphans, "--drop-orphans"},
                      {given.separate, "--separate"},
                      {options.repair.keep_largest != 0, "--keep-largest"},
                      {options.loss == Options::Loss::Refuse, "--strict-attributes"}});
}

void check_dry_run(const GivenOptions& given, const Options& options) {
  const std::string option =
      first_given({{options.output.has_value(), "-o"},
                   {options.loss == Options::Loss::Refuse, "--strict-attributes"}});
  if (given.dry_run && !option.empty()) {
    throw UsageError("--dry-run writes nothing, so " + option + " cannot go with it");
  }
}

void check_combination(const GivenOptions& given, const Options& options) {
  if (given.operations.size() > 1) throw UsageError("one boolean operation at a time");
  if (const std::string option = repair_option(given, options); !option.empty()) {
    throw UsageError(option +
                     " is for the repair of one mesh, so no boolean operation can go with it");
  }
  check_dry_run(given, options);
  if (!given.dry_run && !options.output) {
    throw UsageError("no OUT: name it with -o, or ask for --dry-run");
  }
  const bool is_in_order = given.operations.front() == BooleanOperation::SubtractInOrder;
  if (is_in_order && options.output && options.target != Options::Target::Folder) {
    throw UsageError("--subtract-in-order writes a file for each input: name a folder as OUT");
  }
  if (is_in_order && options.html) throw UsageError("--html makes a page of one mesh");
  if (!is_in_order && options.target == Options::Target::Folder) {
    throw UsageError("the inputs become one mesh: name OUT as one mesh file");
  }
}

void check_borders(const GivenOptions& given, const RepairOptions& repair) {
  if (repair.borders != Borders::Intended) return;
  if (repair.solid) {
    throw UsageError("--keep-borders fills no hole, so --solid cannot go with it");
  }
  if (names_holes(given)) {
    throw UsageError("--keep-borders fills no hole, so no --fill- option can go with it");
  }
  if (named_by(given.fix).contains(DefectCode::Hole)) {
    throw UsageError("--keep-borders fills no hole, so --fix cannot name hole");
  }
}

/// Checks that no defect is both to be fixed and to be left, by name.
void check_codes(const GivenOptions& given, const RepairOptions& repair) {
  const DefectCodes left = named_by(given.no_fix);
  for (const DefectCode code : all_defect_codes()) {
    if (left.contains(code) && named_by(given.fix).contains(code)) {
      throw UsageError("--fix and --no-fix both name " + std::string(defect_name(code)));
    }
  }
  const std::tuple<bool, std::string, DefectCode> fixing_options[] = {
      {names_holes(given), given.hole_option, DefectCode::Hole},
      {repair.solid, "--solid", DefectCode::Hole},
      {repair.guarantee, "--guarantee", DefectCode::Hole},
      {repair.weld_within.has_value(), "--weld", DefectCode::Slit},
      {given.renumber, "--renumber", DefectCode::Numbering},
      {given.drop_orphans, "--drop-orphans", DefectCode::OrphanVertex},
      {given.separate, "--separate", DefectCode::Disjoint}};
  for (const auto& [is_given, option, code] : fixing_options) {
    if (is_given && left.contains(code)) {
      throw UsageError("--no-fix " + std::string(defect_name(code)) + " and " + option +
                       " exclude each other");
    }
  }
}

void check_consistent(const GivenOptions& given, const Options& options) {
  if (given.paths.empty()) throw UsageError("no IN: name a mesh file, or - for standard input");
  if (!given.operations.empty()) {
    check_combination(given, options);
    return;
  }
  check_target(given, options);
  if (given.paths.size() > 1 && !options.is_batch()) {
    throw UsageError("one mesh at a time: " + given.paths[1] + " is one too many");
  }
  if (const std::string option = writing_option(given, options); given.find && !option.empty()) {
    throw UsageError("--find only reports, so " + option + " cannot go with it");
  }
  check_dry_run(given, options);
  if (!given.find && !given.dry_run && !options.output && !options.is_batch()) {
    throw UsageError("no OUT: name it with -o, or ask for --find or --dry-run");
  }
  check_borders(given, options.repair);
  check_codes(given, options.repair);
}

/// Returns the defects to fix: those of --fix, else none if only single operations are named, else
/// the default; and those that other options imply.
DefectCodes fixes_of(const GivenOptions& given, const RepairOptions& repair) {
  DefectCodes fixes = default_fixes();
  const bool asks_for_all = given.no_fix || repair.solid || repair.guarantee;
  if (given.fix) {
    fixes = given.fix->codes;
  } else if (names_operation(given, repair) && !asks_for_all) {
    fixes = {};
  }
  if (given.no_fix) {
    for (const DefectCode code : all_defect_codes()) {
      if (given.no_fix->codes.contains(code)) fixes.erase(code);
    }
  }
  if (names_holes(given)) fixes.insert(DefectCode::Hole);
  if (given.renumber) fixes.insert(DefectCode::Numbering);
  if (given.drop_orphans) fixes.insert(DefectCode::OrphanVertex);
  if (given.separate) fixes.insert(DefectCode::Disjoint);
  if (repair.borders == Borders::Intended) fixes.erase(DefectCode::Hole);
  return fixes;
}

void complete(const GivenOptions& given, Options& options) {
  options.paths = given.paths;
  options.input = given.paths.front();
  if (!given.operations.empty()) {
    options.action = Options::Action::Combine;
    options.operation = given.operations.front();
    return;
  }
  options.action = given.find ? Options::Action::Find : Options::Action::Fix;
  options.repair.fixes = fixes_of(given, options.repair);
  const bool is_named = names_holes(given) || named_by(given.fix).contains(DefectCode::Hole);
  RepairOptions& repair = options.repair;
  repair.fill.sheets = is_named || repair.solid ? FillSheets::Yes : FillSheets::No;
  // With any of these a mesh is not good, so that they are fixed unless --no-fix names them.
  for (const DefectCode code : {DefectCode::OrphanVertex, DefectCode::Numbering}) {
    const bool is_left = given.no_fix && given.no_fix->codes.contains(code);
    if (repair.guarantee && !is_left) repair.fixes.insert(code);
  }
  const bool has_one_file_each = options.is_batch() || options.writes_to_stdout();
  if (has_one_file_each && options.repair.fixes.contains(DefectCode::Disjoint)) {
    throw UsageError(std::string(given.separate ? "--separate" : "--fix disjoint") +
                     " makes several files of one mesh: it needs one mesh file as OUT");
  }
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  Options& options = command.options;
  GivenOptions given;
  OptionTable table(
      {.calls = {"meshfixer [options] IN -o OUT", "meshfixer [options] PATH... -o DIR",
                 "meshfixer --in-place [options] PATH...", "meshfixer --find [options] IN",
                 "meshfixer --union [options] PATH... -o OUT"},
       .purpose =
           "Finds what is wrong with a triangle mesh, repairs it as far as it can within a "
           "maximum deviation, writes a new file, and reports the defects that remain. The input "
           "is never changed but by --in-place; sound parts stay unchanged bit for bit.",
       .footer = "Examples:\n"
                 "meshfixer --find cow.obj\n"
                 "meshfixer cow.obj -o cow_fixed.obj\n"
                 "meshfixer --solid --guarantee scan.ply -o scan.stl\n"
                 "meshfixer --in-place --backup models\n"
                 "meshfixer --difference block.stl hole.stl -o drilled.stl\n"
                 "meshfixer --subtract-in-order neurites -o disjoint/\n\n"
                 "Exit status: 0 nothing asked for remains; 1 defects remain; 2 wrong usage; 3 a "
                 "file could not be read or written; 130 interrupted, with several files.",
       .version = "meshfixer " MESHALYZER_VERSION "\n"});
  table.arguments(
      "IN", given.paths,
      "a mesh file (.mesh .obj .off .stl .ply, also .gz) or - for standard input; PATH a mesh file "
      "or a folder: all mesh files in it.");
  declare_actions(table, options, given);
  declare_operations(table, options, given);
  declare_holes(table, options, given);
  declare_booleans(table, given);
  declare_limits(table, options, given);
  declare_reports(table, options);
  command.answer = table.parse(argc, argv);
  if (!command.answer) {
    if (options.output && is_folder_name(*options.output)) {
      options.target = Options::Target::Folder;
    }
    check_consistent(given, options);
    complete(given, options);
  }
  return command;
}

}  // namespace meshalyzer::fixer
