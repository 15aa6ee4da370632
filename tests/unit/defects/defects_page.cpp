#include "defects_page.h"

#include "meshalyzer/defects/catalogue.h"

#include <string_view>

namespace meshalyzer {
namespace {

constexpr std::string_view kIntroduction =
    R"(<!-- Made from lib/meshalyzer/defects/catalogue.cpp. UPDATE=1 defects_test writes it anew. -->

# Defects

This page lists the defects that `meshfixer --find`, and `find_defects` in the library, find in a mesh. [definitions.md](definitions.md)
defines the words. A defect is a value: its code, how severe it is, the vertices, edges and faces that it is about
(by the ids of the file), a place to look at, the measured value and its limit, and whether `meshfixer` has a fix for it.
Codes are never renamed.

Defects are listed by code, in the order below, then by their lowest element. The list is the same for any number of threads.

**Severity.** An `error` means that the mesh bounds no solid, or that a program which trusts it may fail on it. A
`warning` means that the surface is as intended, but that the file could be tidier.

**How many.** If `max_defects` is not 0, only that many defects are listed, the first ones. The counts by code stay
complete, and the report says that the list was cut.

## Tolerances

| tolerance | meaning | default |
|---|---|---|
| degeneracy | an edge or altitude shorter than this is degenerate | 1e-8 of the diagonal |
| slit | ends of border edges within this are at one place | 1e-8 of the diagonal |
| height | a foldover lies within this of the faces that it lies on | 1e-8 of the diagonal |
| max fold-over angle | an edge whose smaller face angle is at most this is a fold | 1 degree |

Lengths are in the unit of the mesh. The diagonal is that of the bounding box of the vertices that faces use. One tolerance
may be given for all three lengths, or one for each, which then takes precedence. A slit or height tolerance below the degeneracy
tolerance is inconsistent, and a warning says so: what counts as a point in one place would be a gap in another.

With a tolerance of 0 the conditions are exact: a face is flat when its corners are on one line, an edge is degenerate when
its ends are at one place, and so are two ends of border edges that belong together.

## Check levels

`check` asks whether a mesh is fit for a purpose, at one of three levels.

| level | the mesh must have no |
|---|---|
| `none` | anything is valid |
| `basic` | `corrupt`, `non-manifold`, `degenerate-facet`, `flat-facet`, `vertex-normal`. The mesh of a single face of a body must have no `disjoint` either, and its border must match the given polylines |
| `full` | all of `basic`, and also no `slit` and no `self-intersection` |
)";

void append_row(std::string& text, std::string_view name, std::string_view content) {
  text += "- **";
  text += name;
  text += ":** ";
  text += content;
  text += '\n';
}

void append_section(std::string& text, const CatalogueEntry& entry) {
  text += "\n### `";
  text += defect_name(entry.code);
  text += "`\n\n";
  text += entry.meaning;
  text += "\n\n";
  append_row(text, "Severity", severity_name(entry.severity));
  append_row(text, "Listed", entry.elements);
  append_row(text, "Measured", entry.value.empty() ? "nothing." : entry.value);
  append_row(text, "Fix", entry.fix);
  append_row(text, "Passes", entry.passes);
  append_row(text, "Fixed by default", entry.fixed_by_default ? "yes" : "no");
}

}  // namespace

std::string defects_page() {
  std::string text(kIntroduction);
  text += "\n## Codes\n\n| code | severity | fixed by default |\n|---|---|---|\n";
  for (const CatalogueEntry& entry : defect_catalogue()) {
    text += "| [`";
    text += defect_name(entry.code);
    text += "`](#";
    text += defect_name(entry.code);
    text += ") | ";
    text += severity_name(entry.severity);
    text += entry.fixed_by_default ? " | yes |\n" : " | no |\n";
  }
  for (const CatalogueEntry& entry : defect_catalogue()) append_section(text, entry);
  return text;
}

}  // namespace meshalyzer
