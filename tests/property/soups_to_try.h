#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// A mesh to hold a law against.
struct NamedSoup {
  std::string name;
  Soup soup;
};

/// Every mesh file of meshes/ that can be read, in name order, then random soups: faces over few
/// lattice points, where everything touches and overlaps, and damaged surfaces.
[[nodiscard]] const std::vector<NamedSoup>& soups_to_try();

/// The mesh files below a folder but for those in folders of this name, in name order.
[[nodiscard]] std::vector<std::string> mesh_files(const std::string& folder,
                                                  const std::string& left_out);

}  // namespace meshalyzer
