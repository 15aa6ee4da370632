#include "meshalyzer/prepared/shells.h"

#include "meshalyzer/geometry/extent.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/nesting.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace meshalyzer {
namespace {

/// Leaves each pair of components once, ascending; it crosses if any did.
void merge_contacts(std::vector<PartContact>& contacts) {
  const auto key = [](const PartContact& c) { return std::tuple(c.a, c.b, !c.crosses); };
  std::sort(contacts.begin(), contacts.end(),
            [&](const PartContact& x, const PartContact& y) { return key(x) < key(y); });
  const auto same_parts = [](const PartContact& x, const PartContact& y) {
    return x.a == y.a && x.b == y.b;
  };
  contacts.erase(std::unique(contacts.begin(), contacts.end(), same_parts), contacts.end());
}

/// The pairs of components that intersect, each once, ascending.
std::vector<PartContact> find_contacts(const CutMesh& cut, const Components& components,
                                       std::span<const IntersectingPair> pairs) {
  std::vector<PartContact> contacts;
  // Merged now and then, so that memory follows the pairs of components, not those of faces.
  std::size_t enough = std::size_t{1} << 16;
  for (const IntersectingPair& pair : pairs) {
    const Index a = components.of_face[cut.side.mesh_face(pair.face_a)];
    const Index b = components.of_face[cut.side.mesh_face(pair.face_b)];
    if (a != b) {
      contacts.push_back({std::min(a, b), std::max(a, b), pair.kind == ContactKind::Crossing});
    }
    if (contacts.size() == enough) {
      merge_contacts(contacts);
      enough = std::max(enough, 2 * contacts.size());
    }
  }
  merge_contacts(contacts);
  return contacts;
}

/// #mesh faces: the component of each face; kNoIndex where that is no shell.
std::vector<Index> shell_of_face(const Components& components,
                                 std::span<const std::uint8_t> is_shell) {
  std::vector<Index> of_face(components.of_face);
  for (Index& c : of_face) {
    c = is_shell[c] != 0 ? c : kNoIndex;
  }
  return of_face;
}

Nesting nesting_of_components(const PreparedMesh& mesh, std::span<const std::uint8_t> is_shell) {
  const Components& components = mesh.components();
  if (components.count == 1) {
    return {.depth = {0}, .inside = {kNoIndex}};  // needs no tree
  }
  const std::vector<PartContact> contacts =
      find_contacts(mesh.cut(), components, mesh.intersecting_pairs());
  return find_nesting(mesh.tree(),
                      {.parts = {.of_face = components.of_face, .count = components.count},
                       .is_closed = is_shell,
                       .contacts = contacts});
}

}  // namespace

std::vector<Shell> find_shells(const PreparedMesh& mesh) {
  const Components& components = mesh.components();
  const std::vector<std::uint8_t> is_shell = which_are_shells(mesh.cut(), components);
  std::vector<Shell> shells(components.count);
  if (std::find(is_shell.begin(), is_shell.end(), 1) == is_shell.end()) {
    return shells;  // no need to search for intersections
  }
  const std::vector<Index> of_face = shell_of_face(components, is_shell);
  const std::vector<SignedVolume> volumes = signed_volumes(
      mesh.cut().mesh, {.of_face = of_face, .count = components.count}, mesh.component_boxes());
  const Nesting nesting = nesting_of_components(mesh, is_shell);
  for (std::size_t c = 0; c < components.count; ++c) {
    shells[c].inside = nesting.inside[c];
    if (is_shell[c] != 0 && std::isfinite(volumes[c].value)) {
      shells[c].volume = volumes[c].value;
    }
    if (is_shell[c] != 0 && volumes[c].sign != 0) {
      shells[c].outward = (volumes[c].sign > 0) == (nesting.depth[c] % 2 == 0);
    }
  }
  return shells;
}

std::vector<std::uint8_t> which_are_shells(const CutMesh& cut, const Components& components) {
  std::vector<std::uint8_t> is_shell(components.count, 1);
  const auto rule_out = [&](FaceHandle face) {
    is_shell[components.of_face[static_cast<std::size_t>(face.idx())]] = 0;
  };
  // Borders of the cut mesh are borders of the complex, and edges that are not manifold or not
  // consistent.
  for (const HalfedgeHandle h : cut.mesh.all_halfedges()) {
    if (cut.mesh.is_boundary(h)) {
      rule_out(cut.mesh.face_handle(cut.mesh.opposite_halfedge_handle(h)));
    }
  }
  for (const Index v : cut.side.non_manifold_vertices) {
    const HalfedgeHandle h = cut.mesh.halfedge_handle(VertexHandle(static_cast<int>(v)));
    const FaceHandle face = cut.mesh.face_handle(h);
    rule_out(face.is_valid() ? face : cut.mesh.face_handle(cut.mesh.opposite_halfedge_handle(h)));
  }
  return is_shell;
}

}  // namespace meshalyzer
