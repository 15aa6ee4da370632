#include "meshalyzer/spatial/face_order.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/soup.h"
#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

constexpr Index kStations = 64;

/// A square tube along the z axis: between two stations each of its four sides has two faces.
Soup square_tube(double step) {
  Soup soup = shapes::make({}, {});
  for (Index i = 0; i <= kStations; ++i) {
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      soup.positions.emplace_back(x, y, step * i);
    }
  }
  for (Index i = 0; i < kStations; ++i) {
    for (Index side = 0; side < 4; ++side) {
      const Index a = 4 * i + side;
      const Index b = 4 * i + (side + 1) % 4;
      soup.triangles.push_back({a, b, b + 4});
      soup.triangles.push_back({a, b + 4, a + 4});
    }
  }
  return shapes::make(std::move(soup.positions), std::move(soup.triangles));
}

Soup turned(Soup soup) {
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : soup.positions) p = turn * p;
  return soup;
}

Corners face_of(const Soup& soup, Index face) {
  const Triangle& t = soup.triangles[face];
  return {soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
}

std::vector<FaceMiddle> face_middles(const Soup& soup) {
  std::vector<FaceMiddle> faces;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Box3 box = box_of(face_of(soup, f));
    const Vec3 middle = box.min() + box.max();
    faces.push_back({{static_cast<float>(middle[0]), static_cast<float>(middle[1]),
                      static_cast<float>(middle[2])},
                     f});
  }
  return faces;
}

std::vector<Index> order_of(const Soup& soup, std::vector<FaceMiddle> faces) {
  order_for_tree(faces, soup.triangles, soup.positions);
  std::vector<Index> order;
  for (const FaceMiddle& face : faces) order.push_back(face.face);
  return order;
}

std::vector<Index> order_of(const Soup& soup) {
  return order_of(soup, face_middles(soup));
}

TEST(OrderForTree, EightFacesOfALongBodyAreOfOneSide) {
  for (const Soup& tube : {square_tube(10), turned(square_tube(10))}) {
    const std::vector<Index> order = order_of(tube);
    for (std::size_t begin = 0; begin < order.size(); begin += 8) {
      const Vec3 normal = normal_of(face_of(tube, order[begin])).normalized();
      for (std::size_t i = begin; i < begin + 8; ++i) {
        EXPECT_LT((normal_of(face_of(tube, order[i])).normalized() - normal).norm(), 1e-6);
      }
    }
  }
}

TEST(OrderForTree, EightFacesOfABodyWithoutLongOnesAreNextToEachOther) {
  // All faces between two stations.
  const Soup tube = square_tube(3);
  const std::vector<Index> order = order_of(tube);
  for (std::size_t begin = 0; begin < order.size(); begin += 8) {
    Box3 box;
    for (std::size_t i = begin; i < begin + 8; ++i) box.extend(box_of(face_of(tube, order[i])));
    EXPECT_DOUBLE_EQ(box.sizes()[2], 3.0);
  }
}

TEST(OrderForTree, OrderDependsOnTheFacesAlone) {
  for (const double step : {3.0, 10.0}) {
    const Soup tube = turned(square_tube(step));
    const std::vector<Index> order = order_of(tube);
    std::vector<FaceMiddle> faces = face_middles(tube);
    std::shuffle(faces.begin(), faces.end(), std::mt19937(5));
    EXPECT_EQ(order_of(tube, faces), order);
    std::vector<Index> all = order;
    std::sort(all.begin(), all.end());
    for (Index f = 0; f < tube.n_faces(); ++f) EXPECT_EQ(all[f], f);
  }
}

TEST(OrderForTree, LargestDoublesAndFacesWithoutAreaAreOrderedToo) {
  Soup soup = square_tube(10);
  for (Vec3& p : soup.positions) p *= 1e307;
  soup.triangles[5] = {3, 3, 3};
  std::vector<Index> order = order_of(soup, face_middles(square_tube(10)));
  std::sort(order.begin(), order.end());
  for (Index f = 0; f < soup.n_faces(); ++f) EXPECT_EQ(order[f], f);
}

}  // namespace
}  // namespace meshalyzer
