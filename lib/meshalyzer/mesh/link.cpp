#include "meshalyzer/mesh/link.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"

#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

VertexHandle vertex_handle(std::size_t i) {
  return VertexHandle(static_cast<int>(i));
}
HalfedgeHandle halfedge_handle(std::size_t i) {
  return HalfedgeHandle(static_cast<int>(i));
}

/// Calls `body(i)` for each i in [0, n), in parallel.
template <typename Body>
void parallel_each(std::size_t n, Body&& body) {
  parallel_chunks(n, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) body(i);
  });
}

/// Links the inner half-edges of every face, as if no vertex were copied. The handle of a face is
/// that of the side which enters its first corner, so that OpenMesh's circulators begin where the
/// file does.
void link_faces(TriMesh& mesh, const Complex& complex, const EdgeNumbers& edges) {
  parallel_each(complex.faces.size(), [&](std::size_t k) {
    const Triangle& t = complex.triangle(k);
    const std::array sides{halfedge_handle(edges.halfedge[3 * k]),
                           halfedge_handle(edges.halfedge[3 * k + 1]),
                           halfedge_handle(edges.halfedge[3 * k + 2])};
    const FaceHandle face(static_cast<int>(k));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = i == 2 ? 0 : i + 1;
      mesh.set_vertex_handle(sides[i], vertex_handle(t[next]));
      mesh.set_face_handle(sides[i], face);
      mesh.set_next_halfedge_handle(sides[i], sides[next]);
    }
    mesh.set_halfedge_handle(face, sides[2]);
  });
}

/// Moves the inner half-edges that enter a further fan to its copy of the vertex.
void enter_copies(TriMesh& mesh, const EdgeNumbers& edges, const Fans& fans,
                  std::size_t n_file_vertices) {
  for (std::size_t i = 0; i < fans.copies.size(); ++i) {
    for (const Index corner : fans.copied_corners[i]) {
      mesh.set_vertex_handle(halfedge_handle(edges.halfedge[previous_corner(corner)]),
                             vertex_handle(n_file_vertices + i));
    }
  }
}

void set_vertices(TriMesh& mesh, std::span<const Vec3> positions, const EdgeNumbers& edges,
                  const Fans& fans) {
  parallel_each(fans.first_corner.size(), [&](std::size_t v) {
    const std::size_t file_vertex = v < positions.size() ? v : fans.copies[v - positions.size()];
    mesh.set_point(vertex_handle(v), positions[file_vertex]);
    const Index corner = fans.first_corner[v];
    if (corner != kNoIndex) {
      mesh.set_halfedge_handle(vertex_handle(v), halfedge_handle(edges.halfedge[corner]));
    }
  });
}

/// Links the border half-edges into loops, each round its own fans, and lets border vertices begin
/// at theirs.
void link_borders(TriMesh& mesh, const EdgeNumbers& edges) {
  parallel_each(edges.border_edges.size(), [&](std::size_t i) {
    const HalfedgeHandle side = halfedge_handle(std::size_t{2} * edges.border_edges[i]);
    // Turn round the vertex that the side leaves, and the border enters, to the other end of its
    // fan.
    HalfedgeHandle incoming = mesh.prev_halfedge_handle(side);
    const VertexHandle vertex = mesh.to_vertex_handle(incoming);
    while (!mesh.is_boundary(mesh.opposite_halfedge_handle(incoming))) {
      incoming = mesh.prev_halfedge_handle(mesh.opposite_halfedge_handle(incoming));
    }
    const HalfedgeHandle border = mesh.opposite_halfedge_handle(side);
    const HalfedgeHandle next_border = mesh.opposite_halfedge_handle(incoming);
    mesh.set_vertex_handle(border, vertex);
    mesh.set_next_halfedge_handle(border, next_border);
    mesh.set_halfedge_handle(vertex, next_border);
  });
}

/// The edges whose lowest side is in a chunk of sides, or in all chunks before it.
struct EdgeCounts {
  Index edges = 0;
  Index borders = 0;
};

/// Replaces the counts of each chunk by those of all chunks before it, and returns those of all.
EdgeCounts number_on(std::vector<EdgeCounts>& counts) {
  EdgeCounts sum;
  for (EdgeCounts& each : counts) {
    const EdgeCounts before = sum;
    sum = {.edges = sum.edges + each.edges, .borders = sum.borders + each.borders};
    each = before;
  }
  return sum;
}

}  // namespace

EdgeNumbers number_edges(std::vector<Index> opposite) {
  EdgeNumbers edges;
  edges.halfedge = std::move(opposite);
  std::vector<Index>& halfedge = edges.halfedge;
  std::vector<std::uint8_t> is_lower(halfedge.size());
  auto numbers = map_chunks<EdgeCounts>(halfedge.size(), [&](Chunk sides) {
    EdgeCounts counts;
    for (std::size_t side = sides.begin; side < sides.end; ++side) {
      is_lower[side] = halfedge[side] > side ? 1 : 0;
      counts.edges += is_lower[side];
      counts.borders += halfedge[side] == kNoIndex ? 1 : 0;
    }
    return counts;
  });
  const EdgeCounts all = number_on(numbers);
  edges.n_edges = all.edges;
  edges.border_edges.resize(all.borders);
  // The two entries of an edge are read and written only where its lower side is met.
  parallel_chunks(halfedge.size(), [&](Chunk sides) {
    EdgeCounts next = numbers[sides.number];
    for (std::size_t side = sides.begin; side < sides.end; ++side) {
      if (is_lower[side] == 0) continue;
      const Index other = std::exchange(halfedge[side], 2 * next.edges);
      if (other == kNoIndex) {
        edges.border_edges[next.borders++] = next.edges;
      } else {
        halfedge[other] = 2 * next.edges + 1;
      }
      ++next.edges;
    }
  });
  return edges;
}

TriMesh link_mesh(const Complex& complex, std::span<const Vec3> positions, const EdgeNumbers& edges,
                  const Fans& fans) {
  constexpr auto kMaxHandle = static_cast<std::size_t>(std::numeric_limits<int>::max());
  if (edges.n_edges > kMaxHandle / 2 || fans.first_corner.size() > kMaxHandle) {
    throw InvalidArgument("build: the mesh has more edges or vertices than a handle can number");
  }
  TriMesh mesh;
  mesh.resize(fans.first_corner.size(), edges.n_edges, complex.faces.size());
  link_faces(mesh, complex, edges);
  enter_copies(mesh, edges, fans, positions.size());
  set_vertices(mesh, positions, edges, fans);
  link_borders(mesh, edges);
  return mesh;
}

}  // namespace meshalyzer
