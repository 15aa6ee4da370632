#include "options.h"

#include "arguments.h"
#include "check_options.h"
#include "values.h"

namespace meshalyzer {
namespace {

void declare_questions(OptionTable& table, Options& options) {
  MeshRequest& mesh = options.mesh;
  table.group("Tasks");
  table.flag(
      "-a,--attributes", [&mesh] { mesh.scope = Scope::AttributesOnly; }, "only the attributes");
  table.option(
      "-g,--good AR,ANGLE,LEN", into(mesh.goodness, to_thresholds),
      "is the mesh good? Prints 1 or 0, with -p every reason. Good: closed, manifold, "
      "outward, no intersecting faces, no orphan, missing vertex, degenerate face or torn line, "
      "contiguous numbering, largest aspect ratio < AR, smallest edge angle > ANGLE "
      "degrees, shortest edge > LEN; not with -a");
  table.flag("-i,--intersections", options.questions.intersections,
             "set: faces of different meshes that share a point, and meshes inside others");
  table.flag("-s,--separation", options.questions.separation,
             "set: for each vertex the distance to the closest point of any other mesh, negative "
             "inside one; every mesh must be good. Without -i, -s, -a and -g a folder is asked "
             "for both");
  table.flag("-v,--volume", options.total_volume, "folder: print only the total volume of the set");
  table.flag("--exact-coincidence", mesh.exact_coincidence,
             "indistinguishable vertices: only those at exactly the same place");
  table.option_or("mixed", "--curvature[=AREA]", into(mesh.curvature, to_area),
                  "also the Gaussian, mean (signed) and principal curvatures at the vertices, "
                  "spread over their mixed areas, or with AREA over: voronoi, barycentric, "
                  "one-ring");
}

void declare_names(OptionTable& table, Options& options) {
  MeshRequest& mesh = options.mesh;
  table.group("Elements to name, by their ids in the file");
  table.flag(
      "-p,--offenders", [&options] { options.offenders = OffenderStyle::Ids; },
      "every offending element");
  table.flag(
      "-q,--points", [&options] { options.offenders = OffenderStyle::CustomPoints; },
      "as -p, vertices as DReAMM custom points: x y z 1 0 0 1");
  table.option("-b,--shorter-than N", into(mesh.shorter_than, to_real), "edges shorter than N");
  table.option("-c,--longer-than N", into(mesh.longer_than, to_real), "edges longer than N");
  table.option("-d,--angle-below N", into(mesh.angle_below_degrees, to_real),
               "edges with an angle smaller than N degrees");
  table.option("-e,--angle-above N", into(mesh.angle_above_degrees, to_real),
               "edges with an angle larger than N degrees");
  table.option("-f,--aspect-above N", into(mesh.aspect_above, to_real),
               "faces with an aspect ratio larger than N");
}

void declare_separation(OptionTable& table, Options& options) {
  SeparationOptions& separation = options.separation;
  table.group("Separation (-s)");
  table.option("--search-radius R", into(separation.search_radius, to_length),
               "vertices with nothing within R are counted, not measured");
  table.option("--search-cone DEG", into(separation.search_cone_degrees, to_cone),
               "only points within DEG degrees, 0 to 90, of the vertex normal (70 is usual)");
  table.option("--include-self R", into(separation.include_self, to_length),
               "also the mesh's own surface, but for faces with a vertex that is reached along "
               "edges within R: the width of a fold");
  table.flag("--force", options.force, "measure although a mesh is not good");
  table.option("--separation-ply DIR", into(options.separation_ply),
               "write a PLY of each mesh to DIR, its vertices coloured by separation");
}

void declare_pictures(OptionTable& table, Options& options) {
  FieldExport& wanted = options.field_export;
  table.group("Pictures");
  table.option("--html FILE", into(options.html),
               "the report as one page that opens in any browser, offline, with a 3D view, every "
               "defect in a list and shown in place; for several meshes an index, and their "
               "pages in a folder, all_pages/ for all.html");
  table.option("--export FILE", into(wanted.file),
               "write a field as quality and colour of the vertices of a .ply, .obj or .vtp; "
               "several meshes get a file each, in a folder named like FILE without its ending; "
               "needs --field");
  table.option("--field F", into(wanted.field, to_field),
               "which: " + names_of(computed_field_names(), field_name) + " (needs -s)");
  table.option(
      "--palette NAME", into(wanted.palette, to_palette),
      alternatives_of(all_palettes(), palette_name) + ", in place of the palette that suits F");
}

void declare_reports(OptionTable& table, Options& options) {
  declare_json(table, options);
  table.flag("--summary", options.summary, "one line for each mesh in place of its report");
}

void declare_journal(OptionTable& table, Options& options) {
  table.option_or("-", "--ndjson[=FILE]", into(options.ndjson),
                  "a line of JSON for each mesh as soon as it is done, and for its findings with "
                  "other meshes, in place of text; with FILE the lines go to this journal, and "
                  "the report is text; lines of an earlier run that are still valid stay");
  table.option("--resume FILE", into(options.resume),
               "go on with a journal: files in it that have not changed since are not analysed "
               "again");
  table.option("--shard K/N", into(options.shard, to_shard),
               "do only part K of N of the work; needs --ndjson=FILE, from which `meshalyzer "
               "merge` makes the report of the whole");
}

void declare_bounds(OptionTable& table, Options& options) {
  table.option("--max-list N", into(options.mesh.max_list, to_count),
               "lists of intersecting pairs hold at most N, those of the lowest faces (" +
                   std::to_string(options.mesh.max_list) + "); 0: all. Counts stay complete");
  table.option("--time-limit S", into(options.time_limit, to_seconds),
               "searches for intersecting pairs end S seconds after the start: then there are \"at "
               "least\" as many as were found, and the mesh is not good");
}

void declare_work(OptionTable& table, Options& options) {
  table.option("--memory-limit SIZE", into(options.memory_limit, to_bytes),
               "stay below it (500M, 4G) where the largest few meshes allow it; the default is "
               "half of the memory");
  declare_conduct(table, options);
}

/// Completes options that follow from others: -v prints only one number, and volumes need no more
/// than the attributes do.
void complete(Options& options) {
  if (options.total_volume) {
    options.mesh.scope = Scope::AttributesOnly;
  }
  if (options.resume && !options.ndjson) {
    options.ndjson = ReportTarget{*options.resume};
  }
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  OptionTable table(
      {.calls = {"meshalyzer [options] PATH...", "meshalyzer check [options] PATH...",
                 "meshalyzer merge [options] FILE.ndjson..."},
       .purpose = "Checks triangle meshes: is the file whole, is the surface closed, manifold, "
                  "orientable, consistent and outward, does it intersect itself, and how large, "
                  "long, thin and bent are its parts?",
       .footer = "Examples:\n"
                 "meshalyzer cow.obj\n"
                 "meshalyzer check models\n"
                 "meshalyzer --html cow.html cow.obj\n"
                 "meshalyzer -p -g 100,5,0.1 cow.obj\n"
                 "meshalyzer -i -s --json=set.json neurons\n"
                 "\n"
                 "Exit status: 0 done (with -g: good); 1 with -g: not good; 2 wrong usage; 3 an "
                 "input could not be read, or the report could not be written; 130 interrupted.",
       .version = "meshalyzer " MESHALYZER_VERSION "\n"});
  Options& options = command.options;
  table.arguments(
      "PATH", options.paths,
      "a mesh file (.mesh .obj .off .stl .ply, also .gz), - for standard input, or a folder: "
      "all mesh files in it, in name order, as one set. 'meshalyzer check' judges each by itself.");
  declare_questions(table, options);
  declare_names(table, options);
  declare_separation(table, options);
  declare_pictures(table, options);
  table.group("Reports");
  declare_reports(table, options);
  declare_journal(table, options);
  declare_bounds(table, options);
  declare_work(table, options);
  command.answer = table.parse(argc, argv);
  if (!command.answer) {
    check_options(options);
    complete(options);
  }
  return command;
}

CommandLine parse_merge_command_line(int argc, const char* const* argv) {
  CommandLine command;
  OptionTable table(
      {.calls = {"meshalyzer merge [options] FILE.ndjson..."},
       .purpose = "Makes the report of a run from the journals of its parts (--shard), or from "
                  "the journal of a whole run: byte for byte the report that the run would have "
                  "printed. The journals say what was asked; the options only say how to report "
                  "it.",
       .footer = "Examples:\n"
                 "meshalyzer merge --summary part1.ndjson part2.ndjson\n"
                 "meshalyzer merge --json=set.json part*.ndjson\n"
                 "\n"
                 "The statistics over all faces of a set are computed from the mesh files, which "
                 "must be where they were and unchanged.\n"
                 "\n"
                 "Exit status: 0 done (with -g: good); 1 with -g: not good; 2 wrong usage; 3 a "
                 "part is missing, or a file cannot be read.",
       .version = ""});
  table.arguments("FILE", command.options.paths, "");
  table.group("Reports");
  declare_reports(table, command.options);
  declare_work(table, command.options);
  command.answer = table.parse(argc, argv);
  if (!command.answer && command.options.paths.empty()) {
    throw UsageError("no FILE: name the journals of all parts");
  }
  if (!command.answer) check_reports(command.options);
  return command;
}

}  // namespace meshalyzer
