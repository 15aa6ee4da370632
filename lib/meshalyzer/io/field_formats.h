#pragma once

#include "meshalyzer/io/mesh_field.h"

#include <string>

namespace meshalyzer {

// The functions of print_mesh_field() for each format, which has checked that the field is
// complete.

[[nodiscard]] std::string print_ply_field(const MeshField& field);
[[nodiscard]] std::string print_obj_field(const MeshField& field);
[[nodiscard]] std::string print_vtp_field(const MeshField& field);

}  // namespace meshalyzer
