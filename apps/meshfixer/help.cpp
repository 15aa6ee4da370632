#include "help.h"

namespace meshalyzer::fixer {

std::string_view help_text() {
  return R"(Usage: meshfixer [options] IN -o OUT
       meshfixer --find [options] IN
Finds what is wrong with a triangle mesh, repairs it as far as it can within a
maximum deviation, writes a new file, and says what remains wrong with it. The
input is never changed; what is not broken stays bit for bit.

IN is a mesh file (.mesh .obj .off .stl .ply) or - for standard input; OUT one
with such an ending.

What is done
  -o OUT             where the repaired mesh goes
  --find             only report the defects; of these, --fix and --no-fix say
                     which count for the exit status
  --dry-run          repair and report, but write nothing
  --fix LIST         only these, by code: disjoint, foldover, flat-facet,
                     degenerate-facet, slit, self-intersection, non-manifold,
                     vertex-normal, corrupt, hole, flipped, inward,
                     duplicate-facet, orphan-vertex, numbering; or default
                     (all but disjoint and numbering), or all
  --no-fix LIST      all of these but those named
  --weld TOL         join borders whose ends are within TOL
  --flip             turn every face over
  --renumber         number vertices and faces 1, 2, ..., n
  --drop-orphans     drop vertices that no face uses. These four alone where
                     nothing else is asked for
  --separate         one file a component: OUT_1, OUT_2, ..., largest first;
                     so too where disjoint is fixed, as by --fix all
  --keep-largest N   only the N components with most faces
  --keep-borders     borders are meant: no hole is filled, and their vertices
                     stay where they are
  --by-group         the groups of the file are faces of a body: their common
                     borders keep every vertex and edge
  --fill-holes N     fill loops of at most N edges
  --fill-at X,Y,Z    fill only the loop that is nearest to this point
  --fill-shape SHAPE linear (no new vertices) or smooth (refined and faired);
                     asked for by any of these three or --fix, holes of sheets
                     (surfaces that mean no solid) are filled too
  --keep-contact     copies of a vertex that was split stay in one place

How far it may go
  --max-deviation D  no point of the old surface ends up farther than D from
                     the new one, and outside of hole patches none of the new
                     one from the old; D is a length, or a share of the
                     diagonal as in 0.1%, the default
  --tolerance T      of all three below; default 1e-8 of the diagonal
  --degen-tolerance T    edges and altitudes below it are degenerate
  --slit-tolerance T     border edges within it are at one place
  --height-tolerance T   a foldover is within it of what it lies on
  --max-foldover-angle DEG   of a fold; default 1

How it is told
  -p                 name every element and every change, and what remains but
                     was not asked for
  --max-defects N    list so many defects at most; 0, the default: all
  --json             as JSON in place of text
  --json=FILE        as JSON in FILE, and as text
  --html FILE        as one page that opens in any browser, offline, with a 3D
                     view before and after, every defect in a list and shown
                     in place
  --threads N        at most N threads; 0, the default: one a core
  --quiet            nothing on standard error but what is wrong
  --no-progress      no progress on standard error (only a terminal has it)
  --version          print the version
  -h, --help         print this help

Not available yet in this version: --guarantee; self-intersections are found
and left.

Exit status: 0 nothing asked for remains; 1 defects remain; 2 wrong usage; 3 a
file could not be read or written.
)";
}

}  // namespace meshalyzer::fixer
