#pragma once

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/types.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Appends a line `HEAD X Y Z`, each coordinate as the shortest text that reads back the same.
inline void print_record(std::string& text, std::string_view head, const Vec3& vector) {
  text += head;
  for (const double coordinate : vector) {
    text += ' ';
    append_shortest(text, coordinate);
  }
  text += '\n';
}

/// Calls `print` with the position of each vertex, followed by its normal if the vertices have one.
template <typename Print>
void for_each_vertex(const Soup& soup, Print print) {
  const bool with_normals = has_vertex_normals(soup);
  std::vector<double> numbers;
  for (std::size_t v = 0; v < soup.n_vertices(); ++v) {
    numbers.assign(soup.positions[v].begin(), soup.positions[v].end());
    if (with_normals) {
      numbers.insert(numbers.end(), soup.normals[v].begin(), soup.normals[v].end());
    }
    print(numbers);
  }
}

/// Appends the vertices, a line of numbers each, and the triangles, a line `3 A B C` each, which
/// follow the head of OFF and of ASCII PLY.
inline void print_vertices_and_triangles(std::string& text, const Soup& soup) {
  for_each_vertex(soup, [&](const std::vector<double>& numbers) {
    for (const double number : numbers) {
      append_shortest(text, number);
      text += ' ';
    }
    text.back() = '\n';
  });
  for (const Triangle& t : soup.triangles) {
    text += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]) +
            '\n';
  }
}

}  // namespace meshalyzer
