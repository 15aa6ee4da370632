#include "meshalyzer/boolean/operands.h"

#include "meshalyzer/base/sum.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace meshalyzer {
namespace {

/// Adds what a mesh says behind what is there.
class Concatenation {
 public:
  void add(const Soup& mesh) {
    const auto n_vertices = static_cast<Index>(all_.n_vertices());
    const auto n_faces = static_cast<Index>(all_.n_faces());
    add_groups(mesh, n_faces);
    add_normals(mesh, n_faces);
    all_.positions.insert(all_.positions.end(), mesh.positions.begin(), mesh.positions.end());
    append_shifted(mesh.triangles, n_vertices, all_.triangles);
    for (MissingReference missing : mesh.missing) {
      missing.face += n_faces;
      all_.missing.push_back(missing);
    }
    all_.n_polygons += mesh.n_polygons;
  }

  [[nodiscard]] Soup take() { return std::move(all_); }

 private:
  static void append_shifted(const std::vector<Triangle>& from, Index by,
                             std::vector<Triangle>& to) {
    std::transform(from.begin(), from.end(), std::back_inserter(to), [&](Triangle t) {
      for (Index& i : t) i += i == kNoIndex ? 0 : by;
      return t;
    });
  }

  void add_groups(const Soup& mesh, Index n_faces) {
    const bool begins_without = mesh.groups.empty() || mesh.groups.front().first_face != 0;
    if (!all_.groups.empty() && begins_without && mesh.n_faces() != 0) {
      all_.groups.push_back({"", n_faces});
    }
    for (Group group : mesh.groups) {
      group.first_face += n_faces;
      all_.groups.push_back(std::move(group));
    }
  }

  /// Corners of meshes without normals have none.
  void add_normals(const Soup& mesh, Index n_faces) {
    constexpr Triangle kNone{kNoIndex, kNoIndex, kNoIndex};
    const bool has_any = !all_.corner_normals.empty() || !mesh.corner_normals.empty();
    if (!has_any) return;
    all_.corner_normals.resize(n_faces, kNone);
    if (mesh.corner_normals.empty()) {
      all_.corner_normals.resize(n_faces + mesh.n_faces(), kNone);
    } else {
      append_shifted(mesh.corner_normals, static_cast<Index>(all_.normals.size()),
                     all_.corner_normals);
    }
    all_.normals.insert(all_.normals.end(), mesh.normals.begin(), mesh.normals.end());
  }

  Soup all_;
};

/// #components: the component that each is a part of the solid of. A cavity's wall points into it,
/// so that its volume is negative.
std::vector<Index> find_owners(const std::vector<Shell>& shells) {
  std::vector<Index> owners(shells.size());
  std::iota(owners.begin(), owners.end(), Index{0});
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const bool is_cavity = shells[i].outward == true && shells[i].volume.value_or(0.0) < 0.0;
    if (is_cavity && shells[i].inside != kNoIndex) owners[i] = shells[i].inside;
  }
  return owners;
}

}  // namespace

Soup concatenate(std::span<const Soup> meshes) {
  Concatenation all;
  for (const Soup& mesh : meshes) all.add(mesh);
  return all.take();
}

Operands operands_of(const Soup& all, std::span<const Soup> meshes) {
  Operands operands{all, {}, meshes.size()};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    operands.of_face.insert(operands.of_face.end(), meshes[i].n_faces(), static_cast<Index>(i));
  }
  return operands;
}

Operands operands_of(const Soup& soup) {
  const PreparedMesh mesh(soup);
  const std::vector<Index> component_of =
      components_of_file_faces(mesh.cut(), mesh.components(), soup.n_faces());
  const std::vector<Index> owners = find_owners(mesh.shells());
  std::vector<Index> number(owners.size(), kNoIndex);
  Operands operands{soup, std::vector<Index>(soup.n_faces(), 0), 0};
  // The wall of a cavity may come before that of its solid.
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    // A face in no complex bounds nothing.
    if (component_of[f] == kNoIndex) continue;
    Index& operand = number[owners[component_of[f]]];
    if (operand == kNoIndex) operand = static_cast<Index>(operands.count++);
    operands.of_face[f] = operand;
  }
  operands.count = std::max<std::size_t>(operands.count, 1);
  return operands;
}

std::vector<double> volumes_of(const Operands& operands) {
  const Soup& soup = operands.soup;
  Box3 box;
  for (const Vec3& p : soup.positions) box.extend(p);
  // About a point near the mesh, so that one far from the origin keeps its digits.
  const Vec3 centre = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
  std::vector<CompensatedSum> sums(operands.count);
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (!is_in_complex(soup.triangles[f])) continue;
    const auto [a, b, c] = corners_of(soup, f);
    sums[operands.of_face[f]].add((a - centre).dot((b - centre).cross(c - centre)));
  }
  std::vector<double> volumes;
  for (const CompensatedSum& sum : sums) volumes.push_back(sum.value() / 6.0);
  return volumes;
}

}  // namespace meshalyzer
