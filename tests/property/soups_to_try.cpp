#include "soups_to_try.h"

#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/read.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <random>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kRandomSoups = 300;

/// Any faces over the points of a small lattice: degenerate, flat, duplicate, with missing
/// vertices.
Soup lattice_soup(std::uint32_t seed) {
  std::mt19937 random(seed);
  Soup soup;
  const Index n_vertices = 4 + below(random, 9);
  for (Index v = 0; v < n_vertices; ++v) {
    soup.positions.emplace_back(below(random, 3), below(random, 3), below(random, 3));
  }
  const Index n_faces = below(random, 20);
  for (Index f = 0; f < n_faces; ++f) {
    Triangle t{};
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
      t[corner] = below(random, n_vertices);
      if (below(random, 60) != 0) continue;
      t[corner] = kNoIndex;
      soup.missing.push_back({f, corner, 100 + below(random, 2)});
    }
    soup.triangles.push_back(t);
  }
  return soup;
}

/// Surfaces across each other that have lost some faces and had others turned over or given twice.
Soup damaged_soup(std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::vector<Soup> surfaces{shapes::icosphere(1), shapes::torus(2, 1, 7, 6),
                                   shapes::cube(2.0), shapes::klein_bottle(5, 4),
                                   shapes::genus_block(1)};
  const auto any = [&] { return surfaces[below(random, static_cast<Index>(surfaces.size()))]; };
  const Vec3 by(0.25 * below(random, 12), 0.25 * below(random, 12), 0.25 * below(random, 12));
  Soup soup = shapes::merged(any(), shapes::translated(any(), by));
  const Index rarity = 20 + below(random, 300);
  return damaged(std::move(soup), rarity, random);
}

std::vector<NamedSoup> make_soups() {
  std::vector<NamedSoup> all;
  for (const std::string& file : mesh_files(MESHALYZER_MESHES, "broken")) {
    all.push_back({file, read_mesh(file)});
  }
  for (std::uint32_t seed = 0; seed < kRandomSoups; ++seed) {
    all.push_back({"lattice, seed " + std::to_string(seed), lattice_soup(seed)});
    all.push_back({"damage, seed " + std::to_string(seed), damaged_soup(seed)});
  }
  return all;
}

}  // namespace

const std::vector<NamedSoup>& soups_to_try() {
  static const std::vector<NamedSoup> all = make_soups();
  return all;
}

std::vector<std::string> mesh_files(const std::string& folder, const std::string& left_out) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const bool is_left_out = entry.path().parent_path().filename() == left_out;
    if (entry.is_regular_file() && !is_left_out && format_of_name(entry.path().string())) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace meshalyzer
