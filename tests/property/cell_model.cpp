#include "cell_model.h"

#include "support/shapes.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

template <typename Body>
void for_each_place(const Body& body) {
  for (int x = 0; x < CellModel::kSize; ++x) {
    for (int y = 0; y < CellModel::kSize; ++y) {
      for (int z = 0; z < CellModel::kSize; ++z) body(x, y, z);
    }
  }
}

std::size_t number(int x, int y, int z) {
  return static_cast<std::size_t>((x * CellModel::kSize + y) * CellModel::kSize + z);
}

}  // namespace

CellModel::CellModel(const std::vector<Box>& boxes, const InsideRule& rule) {
  for_each_place([&](int x, int y, int z) {
    std::vector<int> windings;
    for (const Box& box : boxes) {
      const std::array<int, 3> cell{x, y, z};
      bool is_in = true;
      for (std::size_t k = 0; k < 3; ++k) {
        is_in = is_in && box[k][0] <= cell[k] && cell[k] < box[k][1];
      }
      windings.push_back(is_in ? 1 : 0);
    }
    is_inside_[number(x, y, z)] = rule(windings);
  });
}

int CellModel::volume() const {
  return static_cast<int>(std::count(is_inside_.begin(), is_inside_.end(), true));
}

int CellModel::euler_characteristic() const {
  int sum = 0;
  for_each_place([&](int x, int y, int z) {
    // Seven of the eight parts of the dual cell begin here: a vertex, three edges, three squares.
    for (int span = 0; span < 7; ++span) {
      const std::array<int, 3> extent{span & 1, span >> 1 & 1, span >> 2 & 1};
      const int dimension = extent[0] + extent[1] + extent[2];
      if (is_on_boundary({x, y, z}, extent)) sum += dimension % 2 == 0 ? 1 : -1;
    }
  });
  return sum;
}

bool CellModel::inside(int x, int y, int z) const {
  return x >= 0 && y >= 0 && z >= 0 && is_inside_[number(x, y, z)];
}

bool CellModel::is_on_boundary(const std::array<int, 3>& at,
                               const std::array<int, 3>& extent) const {
  int n = 0;
  int n_inside = 0;
  for (int dx = extent[0] - 1; dx <= 0; ++dx) {
    for (int dy = extent[1] - 1; dy <= 0; ++dy) {
      for (int dz = extent[2] - 1; dz <= 0; ++dz) {
        ++n;
        if (inside(at[0] + dx, at[1] + dy, at[2] + dz)) ++n_inside;
      }
    }
  }
  return n_inside != 0 && n_inside != n;
}

Soup box_mesh(const CellModel::Box& box) {
  Soup soup = shapes::cube();
  for (Vec3& p : soup.positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      double& x = p[static_cast<Eigen::Index>(k)];
      x = box[k][0] + x * (box[k][1] - box[k][0]);
    }
  }
  return soup;
}

}  // namespace meshalyzer
