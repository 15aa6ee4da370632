#include "combine.h"

#include "judge_file.h"
#include "mesh_paths.h"
#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/boolean/make_disjoint.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/repair/combine/mend_combined.h"
#include "meshalyzer/repair/combine/track_combined.h"
#include "meshalyzer/report/json/boolean_report.h"
#include "meshalyzer/report/text/boolean_report.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "operand_files.h"
#include "output.h"
#include "page.h"
#include "stop_request.h"
#include "targets.h"
#include "write_report.h"

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

InsideRule rule_of(BooleanOperation operation) {
  switch (operation) {
    case BooleanOperation::Union:
      return union_rule();
    case BooleanOperation::Intersection:
      return intersection_rule();
    case BooleanOperation::Difference:
    case BooleanOperation::SubtractInOrder:
      break;
  }
  return difference_rule();
}

/// A result, and the inputs from which its file is made.
struct Result {
  const CombinedSolid& solid;
  /// All operands, concatenated.
  const Soup& all;
  /// The files of the operands. If the others are only subtracted from the first, the result is an
  /// edited version of its file.
  std::vector<Source> sources;
  bool edits_first = false;
  /// What the result must have no point in common with; null if there is nothing.
  const Soup* others = nullptr;
  /// Tells whether it has none before it is repaired.
  bool is_apart = true;

  [[nodiscard]] const Soup& edited() const { return edits_first ? sources.front().soup : all; }
};

/// What a result is called that is not written.
constexpr const char* kUnwrittenResult = "the result";

/// Runs a boolean operation and keeps its report.
class CombinationRun {
 public:
  CombinationRun(const Options& options, const OperandFiles& operands, Streams streams)
      : options_(options), operands_(operands), streams_(streams), stop_(options.time_limit) {
    report_.operation = options.operation;
  }

  ExitCode run() {
    if (options_.operation == BooleanOperation::SubtractInOrder) {
      subtract_each_in_order();
    } else {
      combine_into_one();
    }
    report_.lost = summed(std::move(report_.lost));
    // Standard output receives only the mesh.
    const Streams streams_of_report{options_.writes_to_stdout() ? streams_.err : streams_.out,
                                    streams_.err};
    const ExitCode status = write_report(
        options_, streams_of_report, [&] { return text_report(report_); },
        [&] { return json_report(report_); });
    return std::max(status, worst_);
  }

 private:
  [[nodiscard]] std::size_t n_files() const { return operands_.files.size(); }

  [[nodiscard]] Source source(std::size_t i) const {
    return {*operands_.files[i], operands_.soups[i]};
  }

  [[nodiscard]] CombineOptions combine_options(const Soup& all) const {
    CombineOptions options;
    options.max_deviation = length_of(options_.repair.max_deviation, used_box(all));
    options.wants_to_stop = [this] { return stop_.is_made(); };
    return options;
  }

  void combine_into_one() {
    const bool is_one = n_files() == 1;
    const Soup joined = is_one ? Soup() : concatenate(operands_.soups);
    const Soup& all = is_one ? operands_.soups.front() : joined;
    const Operands operands = is_one ? operands_of(all) : operands_of(all, operands_.soups);
    const CombinedSolid solid =
        combine_solids(operands, rule_of(options_.operation), combine_options(all));
    report_.n_pairs = solid.n_pairs;
    add_operands(operands, solid);
    Result result{solid, all, {}, is_one || options_.operation == BooleanOperation::Difference};
    for (std::size_t i = 0; i < n_files(); ++i) result.sources.push_back(source(i));
    const std::optional<Soup> disk = add_result(result, options_.output);
    if (disk && options_.html) write_page_of(*disk);
  }

  /// Writes the page of the defects of the result.
  void write_page_of(const Soup& disk) const {
    const PreparedMesh mesh(disk);
    const std::string& path = report_.outputs.back().path;
    const MeshName name = name_of(disk, path.empty() ? kUnwrittenResult : path);
    const DefectReport found = find_defects(mesh, {.codes = DefectCodes::all()});
    write_page(*options_.html, {name, found, options_.repair.fixes, scene_of(mesh, found)});
  }

  /// Subtracts from the solid of each file those of the files before it.
  void subtract_each_in_order() {
    subtract_in_order(operands_.soups,
                      [this](std::size_t i, const std::vector<Soup>& soups, const Soup& others) {
                        return subtract(i, soups, others);
                      });
  }

  /// Subtracts all other meshes from the first, which is that of file i.
  /// @return The mesh as it is on disk; an empty one if there is none.
  Soup subtract(std::size_t i, const std::vector<Soup>& soups, const Soup& others) {
    const Soup all = concatenate(soups);
    const Operands operands = operands_of(all, soups);
    const PartedDifference left = subtract_and_part(operands, others, combine_options(all));
    report_.n_pairs += left.solid.n_pairs;
    subject_ = operands_.files[i]->path() + ": ";
    std::optional<std::string> path;
    if (options_.output) path = result_path(options_, operands_.files[i]->path());
    add_operands({soups.front(), std::vector<Index>(soups.front().n_faces(), 0), 1}, left.solid);
    note_parting(left);
    std::optional<Soup> disk =
        add_result({left.solid, all, {source(i)}, true, &others, left.is_apart}, path);
    if (!disk) return {};
    check_apart(*disk, others);
    return std::move(*disk);
  }

  /// Reports if a mesh, as it is on disk, intersects one before it.
  void check_apart(const Soup& disk, const Soup& others) {
    const CutMesh mesh = build(disk);
    const CutMesh before = build(others);
    const std::size_t n = find_intersections(mesh, FaceTree(mesh), before, FaceTree(before)).size();
    if (n == 0) return;
    note(grouped(n) + " pairs of faces still meet a mesh before it" +
         (stop_.is_made() ? ", since it was stopped before it was done"
                          : ": neither moving vertices nor cutting back parts them within the "
                            "maximum deviation"));
    be_at_least(ExitCode::NotGood);
  }

  /// Adds a sentence on the operation, or on the file whose result is being made.
  void note(const std::string& text) { report_.notes.push_back(subject_ + text); }

  /// Notes how a file was parted from the meshes before it.
  void note_parting(const PartedDifference& left) {
    if (left.n_moved > 0) {
      note(counted(left.n_moved, "vertex was", "vertices were") +
           " moved off the meshes before it");
    }
    if (left.cut_back > 0.0) {
      note("cut back by at most " + readable(left.cut_back) +
           " where moving vertices did not part it from the meshes before it");
    }
  }

  /// Reports operands, and how much of each is in a result.
  void add_operands(const Operands& operands, const CombinedSolid& solid) {
    const std::size_t first = report_.operands.size();
    const std::vector<double> volumes = volumes_of(operands);
    for (std::size_t i = 0; i < operands.count; ++i) {
      BooleanOperand& operand = report_.operands.emplace_back();
      operand.name = name_of_operand(first + i);
      operand.volume = volumes[i];
    }
    enum : std::uint8_t { Gone, Cut, Whole };
    std::vector<std::uint8_t> outcomes(operands.soup.n_faces(), Gone);
    if (!is_given_up(solid)) {
      for (const CombinedFace& face : solid.faces) {
        if (face.origin >= outcomes.size()) continue;
        outcomes[face.origin] = whole_face(solid, operands.soup, face) ? Whole : Cut;
      }
    }
    for (std::size_t f = 0; f < outcomes.size(); ++f) {
      BooleanOperand& operand = report_.operands[first + operands.of_face[f]];
      ++operand.n_faces;
      ++(outcomes[f] == Whole ? operand.n_whole
         : outcomes[f] == Cut ? operand.n_cut
                              : operand.n_gone);
    }
  }

  [[nodiscard]] std::string name_of_operand(std::size_t number) const {
    const bool is_in_order = options_.operation == BooleanOperation::SubtractInOrder;
    if (is_in_order || n_files() > 1) return operands_.files[number]->path();
    const std::string path = operands_.files.front()->path();
    return "component " + std::to_string(number + 1) + " of " + path;
  }

  void be_at_least(ExitCode code) { worst_ = std::max(worst_, code); }

  /// Writes a result, if it is to be written, and reports it.
  /// @return The mesh as it is on disk; nothing if there is none.
  std::optional<Soup> add_result(const Result& result, const std::optional<std::string>& path) {
    if (is_given_up(result.solid)) {
      add_given_up(result.solid);
      return std::nullopt;
    }
    if (result.solid.faces.empty()) {
      add_empty(path);
      return std::nullopt;
    }
    MendedMesh mended = mend(result);
    const bool is_changed = !is_unchanged(result.edited(), result.solid) || mended.is_mended();
    Soup disk = write(result, mended.mesh, is_changed, path);
    report_.outputs.back().largest_move = result.solid.largest_move + mended.largest_move;
    judge(disk);
    return disk;
  }

  /// Mends a result, and keeps it off others.
  MendedMesh mend(const Result& result) {
    CombineOptions options = combine_options(result.all);
    MendedMesh mended = mend_combined(track_combined(result.edited(), result.solid),
                                      result.solid.outcome, result.others != nullptr, options);
    if (result.others != nullptr && (!result.is_apart || mended.is_mended())) {
      const double moved = result.solid.largest_move + mended.largest_move;
      options.max_deviation = std::max(options.max_deviation - moved, 0.0);
      mended = keep_off(std::move(mended), *result.others, options);
    }
    note_mending(mended, result.solid.outcome);
    return mended;
  }

  void note_mending(const MendedMesh& mended, CombineOutcome outcome) {
    if (mended.is_parted) note("parts that touched along an edge or at a vertex were parted");
    if (mended.is_oriented) {
      note("parts that rounding had turned inside out were oriented outwards");
    }
    if (mended.is_repaired) {
      note(outcome == CombineOutcome::Unfinished
               ? "rounding makes faces of the result intersect again and again, so it was repaired"
               : "it touched or intersected itself after vertices were moved, so it was repaired");
    }
    if (mended.is_subtracted_again) {
      note("the meshes before it were subtracted again from the result");
    }
  }

  /// Tells whether there is no result.
  [[nodiscard]] static bool is_given_up(const CombinedSolid& solid) {
    return solid.outcome != CombineOutcome::Done && solid.outcome != CombineOutcome::Unfinished;
  }

  void add_given_up(const CombinedSolid& solid) {
    report_.outputs.push_back({});
    std::string& verdict = report_.outputs.back().verdict;
    if (solid.outcome == CombineOutcome::Stopped) {
      verdict = "stopped";
      note("nothing is written: it was stopped before it was done");
    } else if (solid.outcome == CombineOutcome::TooManyPairs) {
      verdict = "too many intersecting pairs";
      note("nothing is written: more than " + grouped(kMostPairsCombined) +
           " pairs of faces intersect, and no more are cut");
    } else {
      verdict = "too many intersection points";
      note("nothing is written: where faces intersect, they would be cut at more than " +
           grouped(kMostCrossingsCombined) +
           " points inside them, or at points with too many digits");
    }
    be_at_least(ExitCode::NotGood);
  }

  void add_empty(const std::optional<std::string>& path) {
    const std::string where = path.value_or(kUnwrittenResult);
    report_.notes.push_back(where + " is empty: nothing is inside");
    report_.outputs.push_back({});
    report_.outputs.back().verdict = "empty";
    if (!path) return;
    streams_.err << without_controls(where) << ": not written: the result is empty\n";
    be_at_least(ExitCode::Failure);
  }

  [[nodiscard]] static Output output_of(const Result& result, const TrackedMesh& mesh,
                                        bool is_changed, const std::string& path) {
    if (result.edits_first) return make_output(mesh, is_changed, path, result.sources.front());
    return make_joint_output(mesh, result.all, path, result.sources);
  }

  /// Writes a mesh and reads it back.
  Soup write(const Result& result, const TrackedMesh& mesh, bool is_changed,
             const std::optional<std::string>& path) {
    BooleanOutput& listed = report_.outputs.emplace_back();
    if (!path) return mesh.soup;
    const bool is_stdout = options_.writes_to_stdout();
    const std::string name = is_stdout ? name_of_stdout(operands_.soups.front().format) : *path;
    const Output output = output_of(result, mesh, is_changed, name);
    report_.lost.insert(report_.lost.end(), output.loss.lost.begin(), output.loss.lost.end());
    if (!output.note.empty()) note(output.note);
    if (options_.loss == Options::Loss::Refuse && !output.loss.lost.empty()) {
      note("nothing is written, because attributes would be lost");
      be_at_least(ExitCode::NotGood);
      return mesh.soup;
    }
    listed.path = is_stdout ? "-" : *path;
    // The format of standard output is that of the first input.
    return is_stdout ? write_to_stdout(output, name, streams_.out) : write_output(output, *path);
  }

  /// Judges a mesh by the analysis of the file on disk.
  void judge(const Soup& disk) {
    BooleanOutput& output = report_.outputs.back();
    output.n_vertices = disk.n_vertices();
    output.n_faces = disk.n_faces();
    output.volume = volumes_of({disk, std::vector<Index>(disk.n_faces(), 0), 1}).front();
    const Goodness fitness = judge_file(disk, output.path);
    output.is_good = fitness.good;
    output.verdict = verdict_text(fitness);
    if (!output.is_good) be_at_least(ExitCode::NotGood);
  }

  const Options& options_;
  const OperandFiles& operands_;
  Streams streams_;
  StopRequest stop_;
  BooleanReport report_;
  /// What begins notes: the file that others are subtracted from, if each is in turn.
  std::string subject_;
  ExitCode worst_ = ExitCode::Done;
};

}  // namespace

ExitCode combine(const Options& options, Streams streams) {
  const MeshPaths paths = find_meshes(options.paths);
  static_cast<void>(files_of_run(options, paths.files));
  return report_or_reason(options, streams, [&] {
    const OperandFiles operands = read_operands(options, paths);
    if (const std::string faults = solid_faults(operands); !faults.empty()) {
      streams.err << faults << std::endl;
      write_reason_of_no_report(options, streams, faults);
      return ExitCode::NotGood;
    }
    make_output_folder(options);
    return CombinationRun(options, operands, streams).run();
  });
}

}  // namespace meshalyzer::fixer
