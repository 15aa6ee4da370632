#pragma once

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/arrangement/arranged_soup.h"
#include "meshalyzer/mesh/build.h"

#include <utility>

namespace meshalyzer::test {

/// A soup cut along its self-intersections, with all that ArrangedSoup refers to.
struct ArrangedMesh {
  explicit ArrangedMesh(Soup mesh)
      : soup(std::move(mesh)),
        cut(build(soup)),
        tree(cut),
        arrangement(arrange(soup)),
        cells(find_cells(soup, arrangement)),
        arranged{soup, cut, tree, arrangement, cells} {}
  ArrangedMesh(const ArrangedMesh&) = delete;
  ArrangedMesh& operator=(const ArrangedMesh&) = delete;

  Soup soup;
  CutMesh cut;
  FaceTree tree;
  Arrangement arrangement;
  Cells cells;
  ArrangedSoup arranged;
};

}  // namespace meshalyzer::test
