#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/report/mesh_name.h"

#include <cstddef>
#include <span>
#include <string>

namespace meshalyzer {

/// The text of a page on a change of a repair.
struct PageChange {
  /// The name of the pass: "cut intersections", ...
  std::string pass;
  /// The description of the change: "faces 3 4 7 dropped", ...
  std::string text;
};

/// The text of a page on what a repair would make of a patch of intersecting faces.
struct PagePatch {
  /// The index of the patch among the defects.
  std::size_t defect = 0;
  std::string text;
};

/// A mesh with its report, defects and scene for a page. The struct only refers to them.
struct PageMesh {
  const MeshName& name;
  const DefectReport& defects;
  const Scene& scene;
  /// The texts of the scene's changes.
  std::span<const PageChange> changes = {};
  std::span<const PagePatch> patches = {};
};

}  // namespace meshalyzer
