#pragma once

#include "meshalyzer/base/types.h"

// PropertyT::push_back() adds an Eigen vector without initialising it, which Eigen intends and g++
// 12 warns about.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
// The order below matters: OpenMesh 9.0's EigenVectorT.hh does not include what it specialises.
// clang-format off
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// clang-format on
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

static_assert(OM_VERSION >= 0x90000, "meshalyzer needs OpenMesh 9.0 or newer");

namespace meshalyzer {

/// Double positions and normals as Eigen vectors; nothing else is stored per element.
struct TriMeshTraits : OpenMesh::DefaultTraits {
  using Point = Vec3;
  using Normal = Vec3;
};

/// The half-edge mesh of the library: triangles, double positions, manifold by construction.
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<TriMeshTraits>;

using VertexHandle = TriMesh::VertexHandle;
using HalfedgeHandle = TriMesh::HalfedgeHandle;
using EdgeHandle = TriMesh::EdgeHandle;
using FaceHandle = TriMesh::FaceHandle;

}  // namespace meshalyzer
