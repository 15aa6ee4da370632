#pragma once

#include "meshalyzer/io/mesh_field.h"

#include <string>

namespace meshalyzer {

/// print_mesh_field() in FieldFormat::Vtp.
///
/// @param field  Whole, as print_mesh_field() has made sure.
[[nodiscard]] std::string print_vtp_field(const MeshField& field);

}  // namespace meshalyzer
