#include "help.h"

namespace meshalyzer {

std::string_view help_text() {
  return R"(Usage: meshalyzer [options] PATH...
       meshalyzer merge [options] FILE.ndjson...
Checks triangle meshes: is the file whole, is the surface closed, manifold,
orientable, consistent and outward, does it intersect itself, and how large,
long, thin and bent are its parts?

PATH is a mesh file (.mesh .obj .off .stl .ply), - for standard input, or a
folder: all mesh files in it, in name order, as one set.

What is done
  -a                 only the attributes
  -g AR,ANGLE,LEN    is the mesh good? Prints 1 or 0, with -p every reason.
                     Good: closed, manifold, outward, no intersecting faces,
                     no orphan, missing vertex or degenerate face, contiguous
                     numbering, largest aspect ratio < AR, smallest edge
                     angle > ANGLE degrees, shortest edge > LEN; not with -a
  -i                 set: faces of different meshes that share a point, and
                     meshes inside others
  -s                 set: for each vertex the distance to the closest point of
                     any other mesh, negative inside one; every mesh must be
                     good. Without -i, -s, -a and -g a folder is asked for both
  -v                 folder: print only the total volume of the set
  --exact-coincidence
                     indistinguishable vertices: only those at exactly the
                     same place
  --curvature        also the Gaussian, mean (signed) and principal curvatures
                     at the vertices, spread over their mixed areas, or with
                     --curvature=AREA over: voronoi, barycentric, one-ring

Which elements are named, by their ids in the file
  -p                 every offending element
  -q                 as -p, vertices as DReAMM custom points: x y z 1 0 0 1
  -b N               edges shorter than N
  -c N               edges longer than N
  -d N               edges with an angle smaller than N degrees
  -e N               edges with an angle larger than N degrees
  -f N               faces with an aspect ratio larger than N

How separation is measured (-s)
  --search-radius R  vertices with nothing within R are counted, not measured
  --search-cone DEG  only points within DEG degrees, 0 to 90, of the vertex
                     normal (70 is usual)
  --include-self R   also the mesh's own surface, but for faces with a vertex
                     that is reached along edges within R: the width of a fold
  --force            although a mesh is not good
  --separation-ply DIR
                     a PLY of each mesh in DIR, its vertices coloured by it

Pictures
  --html FILE        the report as one page that opens in any browser, offline,
                     with a 3D view, every defect in a list and shown in place;
                     of several meshes an index, the pages in FILE_pages/
  --export FILE --field F
                     a field as quality and colour of the vertices of a .ply,
                     .obj or .vtp; of several meshes a file each, in a folder
                     called as FILE without its ending. F: gaussian, mean, k1,
                     k2, valence, aspect-ratio, area, component, defect,
                     separation (needs -s)
  --palette NAME     viridis, diverging, jet or hot in place of what suits F

How it is told
  --json             as JSON in place of text
  --json=FILE        as JSON in FILE, and as text
  --summary          a line a mesh, in place of its report
  --ndjson           a line of JSON for each mesh as it is done, and for what
                     is between it and the others, in place of text
  --ndjson=FILE      in FILE, a journal, and the report as text; lines that
                     are there of an earlier run, and still hold, stay
  --resume FILE      go on with a journal: what is in it, of files that have
                     not changed since, is not done again
  --shard K/N        only part K of N of the work; needs --ndjson=FILE, of
                     which `meshalyzer merge` makes the report of the whole
  --memory-limit SIZE
                     stay below it (500M, 4G) where the largest few meshes
                     allow it; the default is half of the memory
  --threads N        at most N threads; 0, the default: one a core
  --quiet            nothing on standard error but what is wrong
  --no-progress      no progress on standard error (only a terminal has it)
  --version          print the version
  -h, --help         print this help

Exit status: 0 done (with -g: good); 1 with -g: not good; 2 wrong usage; 3 an
input could not be read, or the report not be written; 130 interrupted.
)";
}

std::string_view merge_help_text() {
  return R"(Usage: meshalyzer merge [options] FILE.ndjson...
Makes the report of a run of the journals of its parts (--shard), or of a whole
one: the same, byte for byte, as the run would have printed. What was asked
stands in the journals; the options only say how to tell it.

  --json             as JSON in place of text
  --json=FILE        as JSON in FILE, and as text
  --summary          a line a mesh, in place of its report
  --threads N, --memory-limit SIZE, --quiet, --no-progress
                     as for meshalyzer
  -h, --help         print this help

The statistics over all faces of a set are made of the mesh files, which must
be where they were and unchanged.

Exit status: 0 done (with -g: good); 1 with -g: not good; 2 wrong usage; 3 a
part is missing, or a file cannot be read.
)";
}

}  // namespace meshalyzer
