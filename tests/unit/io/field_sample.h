#pragma once

#include "meshalyzer/io/mesh_field.h"

#include <limits>
#include <string>
#include <vector>

namespace meshalyzer {

/// A field on two faces, with numbers that a careless writer spoils.
struct FieldSample {
  std::vector<Vec3> positions{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1e300}};
  std::vector<Triangle> triangles{{0, 1, 2}, {3, 1, 0}};
  std::vector<double> values{0.1, -2, 1e-300, std::numeric_limits<double>::quiet_NaN()};
  std::vector<Colour> colours{{1, 2, 3}, {4, 5, 6}, {7, 8, 255}, kNoValueColour};
  /// Empty: a field of vertices.
  std::vector<double> face_values;
  std::vector<Colour> face_colours;
  std::vector<std::string> comments;

  [[nodiscard]] std::string print(FieldFormat format) const {
    return print_mesh_field({.positions = positions,
                             .triangles = triangles,
                             .name = "mean",
                             .vertices = {values, colours},
                             .faces = {face_values, face_colours},
                             .comments = comments},
                            format);
  }
};

/// The same of faces.
[[nodiscard]] inline FieldSample face_field_sample() {
  FieldSample sample;
  sample.face_values = {1.0 / 3.0, std::numeric_limits<double>::infinity()};
  sample.face_colours = {{9, 10, 11}, {12, 13, 14}};
  return sample;
}

}  // namespace meshalyzer
