#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace meshalyzer {

/// The names of the numbers of a vertex that a mesh has: position and normal.
inline constexpr std::array<std::string_view, 6> kPlyVertexNumbers = {"x",  "y",  "z",
                                                                      "nx", "ny", "nz"};

/// The names that programs use for the colours of vertices and faces in PLY files: red, green,
/// blue, opacity.
inline constexpr std::array<std::array<std::string_view, 4>, 3> kPlyColourNames = {{
    {"red", "green", "blue", "alpha"},
    {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
    {"r", "g", "b", "a"},
}};

/// The names that programs use for the two texture coordinates of a vertex.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kPlyVertexTexture = {
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}};

/// The names of lists of a face with two texture coordinates for each corner.
inline constexpr std::array<std::string_view, 2> kPlyCornerTexture = {"texcoord", "texcoords"};

template <std::size_t N>
[[nodiscard]] bool is_one_of(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Tells whether a property of a vertex or face is part of a colour.
[[nodiscard]] inline bool is_ply_colour(std::string_view name) {
  return std::any_of(kPlyColourNames.begin(), kPlyColourNames.end(),
                     [&](const auto& names) { return is_one_of(name, names); });
}

/// Tells whether a property of a vertex or face is part of its texture coordinates.
[[nodiscard]] inline bool is_ply_texture(std::string_view name) {
  return is_one_of(name, kPlyCornerTexture) ||
         std::any_of(kPlyVertexTexture.begin(), kPlyVertexTexture.end(), [&](const auto& names) {
           return name == names.first || name == names.second;
         });
}

}  // namespace meshalyzer
