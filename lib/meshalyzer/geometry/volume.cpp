#include "meshalyzer/geometry/volume.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sum.h"
#include "meshalyzer/exact/exact_volume.h"
#include "meshalyzer/geometry/face_measures.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace meshalyzer {
namespace {

/// Six times the volume of the tetrahedron of a face and the origin, and a bound of the magnitude
/// to which its rounding error is relative.
struct Term {
  double value;
  double magnitude;
};

/// Enough that threads have work, and few enough for a cache.
constexpr std::size_t kTermsAtOnce = std::size_t{1} << 16U;

/// The terms of successive faces.
struct FaceTerms {
  std::size_t first = 0;
  std::span<Term> terms;
};

Term term(const Corners& p, const Vec3& origin) {
  const Vec3 a = p[0] - origin;
  const Vec3 b = p[1] - origin;
  const Vec3 c = p[2] - origin;
  return {a.dot(b.cross(c)), a.lpNorm<1>() * b.lpNorm<1>() * c.lpNorm<1>()};
}

struct PartSum {
  CompensatedSum value;
  double magnitude = 0.0;
};

/// Computes the terms of `terms.size()` faces from the first on, in parallel.
void compute_terms(const TriMesh& mesh, const FaceParts& parts, std::span<const Box3> boxes,
                   FaceTerms out) {
  parallel_chunks(out.terms.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Index part = parts.of_face[out.first + i];
      if (part == kNoIndex) continue;
      out.terms[i] = term(face_corners(mesh, FaceHandle(static_cast<int>(out.first + i))),
                          middle_of(boxes[part]));
    }
  });
}

/// Adds up the terms in order of the faces, some at a time, so that few are in memory.
std::vector<PartSum> sum_terms(const TriMesh& mesh, const FaceParts& parts,
                               std::span<const Box3> boxes) {
  std::vector<Term> room(std::min(mesh.n_faces(), kTermsAtOnce));
  std::vector<PartSum> sums(parts.count);
  for (std::size_t first = 0; first < mesh.n_faces(); first += room.size()) {
    const std::span<Term> terms =
        std::span(room).first(std::min(room.size(), mesh.n_faces() - first));
    compute_terms(mesh, parts, boxes, {first, terms});
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const Index part = parts.of_face[first + i];
      if (part == kNoIndex) continue;
      sums[part].value.add(terms[i].value);
      sums[part].magnitude += terms[i].magnitude;
    }
  }
  return sums;
}

/// Returns the volume of a sum if rounding errors change neither its sign nor its first six digits:
/// the error of each term is below 16 u times its magnitude, 2^-24 of the smallest sum that is
/// sure.
std::optional<SignedVolume> volume_if_sure(const PartSum& sum) {
  const double six_volumes = sum.value.value();
  const double bound = 0x1p-24 * sum.magnitude;
  const bool sure = std::isfinite(bound) && sum.magnitude > 1e-280 && std::abs(six_volumes) > bound;
  if (!sure) return std::nullopt;
  return SignedVolume{.value = six_volumes / 6, .sign = six_volumes > 0 ? 1 : -1};
}

/// Computes the volumes that volume_if_sure() left open, exactly.
void settle_exactly(const TriMesh& mesh, const FaceParts& parts,
                    std::vector<std::optional<SignedVolume>>& volumes) {
  std::vector<ExactVolume> exact(parts.count);
  for (const FaceHandle f : mesh.faces()) {
    const Index part = parts.of_face[static_cast<std::size_t>(f.idx())];
    if (part != kNoIndex && !volumes[part]) {
      const Corners p = face_corners(mesh, f);
      exact[part].add(p[0], p[1], p[2]);
    }
  }
  for (std::size_t i = 0; i < parts.count; ++i) {
    if (!volumes[i]) volumes[i] = {.value = exact[i].value(), .sign = exact[i].sign()};
  }
}

}  // namespace

std::vector<Box3> bounding_boxes(const TriMesh& mesh, const FaceParts& parts) {
  std::vector<Box3> boxes(parts.count);
  for (const FaceHandle f : mesh.faces()) {
    const Index part = parts.of_face[static_cast<std::size_t>(f.idx())];
    if (part == kNoIndex) {
      continue;
    }
    for (const Vec3& corner : face_corners(mesh, f)) {
      boxes[part].extend(corner);
    }
  }
  return boxes;
}

std::vector<SignedVolume> signed_volumes(const TriMesh& mesh, const FaceParts& parts,
                                         std::span<const Box3> boxes) {
  const std::vector<PartSum> sums = sum_terms(mesh, parts, boxes);
  std::vector<std::optional<SignedVolume>> volumes(parts.count);
  std::transform(sums.begin(), sums.end(), volumes.begin(), volume_if_sure);
  if (std::find(volumes.begin(), volumes.end(), std::nullopt) != volumes.end()) {
    settle_exactly(mesh, parts, volumes);
  }
  std::vector<SignedVolume> settled(parts.count);
  std::transform(volumes.begin(), volumes.end(), settled.begin(),
                 [](const std::optional<SignedVolume>& volume) { return *volume; });
  return settled;
}

}  // namespace meshalyzer
