#include "help.h"

namespace meshalyzer {

std::string_view help_text() {
  return R"(Usage: meshalyzer [options] PATH...
Checks triangle meshes: is the file whole, is the surface closed, manifold,
orientable, consistent and outward, does it intersect itself, and how large,
long, thin and bent are its parts?

PATH is a mesh file (.mesh .obj .off .stl .ply), - for standard input, or a
folder: all mesh files in it, in name order, and their totals.

What is done
  -a                 only the attributes
  -g AR,ANGLE,LEN    is the mesh good? Prints 1 or 0, with -p every reason.
                     Good: closed, manifold, outward, no intersecting faces,
                     no orphan, missing vertex or degenerate face, contiguous
                     numbering, largest aspect ratio < AR, smallest edge
                     angle > ANGLE degrees, shortest edge > LEN; not with -a
  -v                 folder: print only the total volume of the set
  --exact-coincidence
                     indistinguishable vertices: only those at exactly the
                     same place

Which elements are named, by their ids in the file
  -p                 every offending element
  -q                 as -p, vertices as DReAMM custom points: x y z 1 0 0 1
  -b N               edges shorter than N
  -c N               edges longer than N
  -d N               edges with an angle smaller than N degrees
  -e N               edges with an angle larger than N degrees
  -f N               faces with an aspect ratio larger than N

How it is told
  --json             as JSON in place of text
  --json=FILE        as JSON in FILE, and as text
  --threads N        at most N threads; 0, the default: one a core
  --quiet            nothing on standard error but what is wrong
  --no-progress      no progress on standard error (only a terminal has it)
  --version          print the version
  -h, --help         print this help

Not available yet in this version: -i, -s, --curvature, --export, --field,
--html.

Exit status: 0 done (with -g: good); 1 with -g: not good; 2 wrong usage; 3 an
input could not be read, or the report not be written.
)";
}

}  // namespace meshalyzer
