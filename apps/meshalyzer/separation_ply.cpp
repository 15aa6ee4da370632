#include "separation_ply.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/ply_field.h"
#include "meshalyzer/io/read.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <set>
#include <system_error>
#include <vector>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

std::vector<Triangle> triangles_in_complex(const Soup& soup) {
  std::vector<Triangle> triangles;
  std::copy_if(soup.triangles.begin(), soup.triangles.end(), std::back_inserter(triangles),
               is_in_complex);
  return triangles;
}

/// The distances of all vertex records: NaN for those that no face uses, of which there are none.
std::vector<double> by_record(const Soup& soup, const std::vector<Triangle>& triangles,
                              const ObjectSeparation& separation) {
  std::vector<std::uint8_t> is_used(soup.n_vertices(), 0);
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      is_used[v] = 1;
    }
  }
  std::vector<double> values(soup.n_vertices(), std::numeric_limits<double>::quiet_NaN());
  auto next = separation.distances.begin();
  for (std::size_t v = 0; v < values.size() && next != separation.distances.end(); ++v) {
    if (is_used[v] != 0) {
      values[v] = *next++;
    }
  }
  return values;
}

/// From 0 on, not from the smallest, so that what is close looks close.
ColourScale scale_from_zero(const std::vector<double>& values, std::optional<double> largest) {
  ColourScale scale = scale_for(values);
  if (scale.palette == Palette::Sequential) {
    scale.min = 0.0;
    scale.max = largest.value_or(scale.max);
  }
  return scale;
}

}  // namespace

std::vector<std::string> picture_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  std::set<std::string> distinct;
  for (const std::string& path : paths) {
    names.push_back(fs::path(path).filename().replace_extension(".ply").string());
    distinct.insert(names.back());
  }
  if (distinct.size() != paths.size()) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
      names[i] = std::to_string(i + 1) + "_" + fs::path(paths[i]).filename().string() + ".ply";
    }
  }
  return names;
}

void write_separation_ply(const std::string& file, const SeparationPicture& picture) {
  const fs::path folder = fs::path(file).parent_path();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw IoError(folder.string(), {}, "cannot be made: " + error.message());
  }
  const Soup soup = read_mesh(picture.path);
  const std::vector<Triangle> triangles = triangles_in_complex(soup);
  const std::vector<double> values = by_record(soup, triangles, picture.separation);
  const ColourScale scale = scale_from_zero(values, picture.largest);
  std::vector<Colour> colours(values.size());
  std::transform(values.begin(), values.end(), colours.begin(),
                 [&](double value) { return scale.colour_of(value); });
  replace_file(file,
               print_ply_field(soup.positions, triangles, {.values = values, .colours = colours}));
}

}  // namespace meshalyzer
