#pragma once

#include "meshalyzer/io/mesh_field.h"

#include <string>

namespace meshalyzer {

// print_mesh_field() for each format; the field is whole, as print_mesh_field() has made sure.

[[nodiscard]] std::string print_ply_field(const MeshField& field);
[[nodiscard]] std::string print_obj_field(const MeshField& field);
[[nodiscard]] std::string print_vtp_field(const MeshField& field);

}  // namespace meshalyzer
