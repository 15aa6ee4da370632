#include "meshalyzer/boolean/operands.h"

#include "meshalyzer/base/sum.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/mesh/require_records.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace meshalyzer {
namespace {

/// Appends meshes to a soup, one after the other.
class Concatenation {
 public:
  void add(const Soup& mesh) {
    require_records(mesh);
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

  /// Appends the normals of a mesh; corners of meshes without normals have none.
  void add_normals(const Soup& mesh, Index n_faces) {
    const bool has_any = !all_.corner_normals.empty() || !mesh.corner_normals.empty();
    if (!has_any) return;
    all_.corner_normals.resize(n_faces, kNoTriangle);
    if (mesh.corner_normals.empty()) {
      all_.corner_normals.resize(n_faces + mesh.n_faces(), kNoTriangle);
    } else {
      append_shifted(mesh.corner_normals, static_cast<Index>(all_.normals.size()),
                     all_.corner_normals);
    }
    all_.normals.insert(all_.normals.end(), mesh.normals.begin(), mesh.normals.end());
  }

  Soup all_;
};

/// Returns for each component the one to whose solid it belongs, which mostly is itself.
///
/// The wall of a cavity points into it, so its volume is negative. A wall that crosses other
/// components encloses nothing itself, and belongs to the first one that it crosses.
std::vector<Index> find_owners(const PreparedMesh& mesh) {
  const std::vector<Shell>& shells = mesh.shells();
  std::vector<Index> owners(shells.size());
  std::iota(owners.begin(), owners.end(), Index{0});
  const auto is_inward = [&](Index i) { return shells[i].outward == false; };
  bool is_any_inward = false;
  for (Index i = 0; i < owners.size(); ++i) {
    const bool is_cavity = shells[i].outward == true && shells[i].volume.value_or(0.0) < 0.0;
    if (is_cavity && shells[i].inside != kNoIndex) owners[i] = shells[i].inside;
    is_any_inward = is_any_inward || is_inward(i);
  }
  if (!is_any_inward) return owners;
  const auto component_of = [&](Index face) {
    return mesh.components().of_face[mesh.cut().side.mesh_face(face)];
  };
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    const Index a = component_of(pair.face_a);
    const Index b = component_of(pair.face_b);
    if (is_inward(a) && owners[a] == a && !is_inward(b)) owners[a] = owners[b];
    if (is_inward(b) && owners[b] == b && !is_inward(a)) owners[b] = owners[a];
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
  require_finite_positions(soup);
  const PreparedMesh mesh(soup);
  const std::vector<Index> component_of =
      components_of_file_faces(mesh.cut(), mesh.components(), soup.n_faces());
  const std::vector<Index> owners = find_owners(mesh);
  std::vector<Index> number(owners.size(), kNoIndex);
  Operands operands{soup, std::vector<Index>(soup.n_faces(), 0), 0};
  // The wall of a cavity may come before that of its solid.
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    // A face outside the complex bounds nothing.
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
  std::vector<Box3> boxes(operands.count);
  const auto for_each_face = [&](const auto& body) {
    for (Index f = 0; f < soup.n_faces(); ++f) {
      if (is_in_complex(soup.triangles[f])) body(operands.of_face[f], corners_of(soup, f));
    }
  };
  for_each_face([&](Index operand, const std::array<Vec3, 3>& corners) {
    boxes[operand].extend(box_of(corners));
  });
  // Each volume is computed about a nearby point, so that a solid far from the origin keeps its
  // digits.
  std::vector<CompensatedSum> sums(operands.count);
  for_each_face([&](Index operand, const std::array<Vec3, 3>& corners) {
    const Vec3 centre = boxes[operand].center();
    sums[operand].add((corners[0] - centre).dot((corners[1] - centre).cross(corners[2] - centre)));
  });
  std::vector<double> volumes;
  for (const CompensatedSum& sum : sums) volumes.push_back(sum.value() / 6.0);
  return volumes;
}

}  // namespace meshalyzer
