#include "meshalyzer/repair/facets/internal/face_changes.h"

namespace meshalyzer {
namespace {

/// Returns the sum of the normals of the faces that have one; zero if none has.
Vec3 mean_normal(const WorkingMesh& mesh, std::span<const FaceChange> faces) {
  Vec3 sum = Vec3::Zero();
  for (const FaceChange& face : faces) {
    if (!mesh.is_thin(face.number)) sum += face.shape.normal;
  }
  return sum;
}

}  // namespace

FaceChange change_of_face(const WorkingMesh& mesh, const MendStep& step, Index face,
                          const Triangle& corners) {
  const Corners before = mesh.corners(mesh.triangle(face));
  return {.number = face,
          .corners = corners,
          .goes = !is_in_complex(corners),
          .before = before,
          .after = mesh.corners_after(step, corners),
          .shape = measure_facet(before)};
}

MendOutcome check_shapes(const WorkingMesh& mesh, std::span<const FaceChange> faces,
                         std::size_t n_thin_gone, double tolerance, TurningOver turning) {
  const Vec3 mean = mean_normal(mesh, faces);
  bool turns_over = false;
  std::size_t n_thin_made = 0;
  for (const FaceChange& face : faces) {
    if (face.goes) {
      n_thin_gone += mesh.is_thin(face.number) ? 1U : 0U;
      continue;
    }
    const FacetShape now = measure_facet(face.after);
    if (!now.is_sound(tolerance)) {
      n_thin_made += mesh.is_thin(face.number) ? 0U : 1U;
      turns_over = turns_over || now.normal.dot(face.shape.normal) < 0.0;
      continue;
    }
    // The normal of a thin face is noise: one that becomes wider must face the same side as the
    // others.
    const Vec3& wanted = mesh.is_thin(face.number) && !mean.isZero(0) ? mean : face.shape.normal;
    turns_over = turns_over || !(now.normal.dot(wanted) > 0.0);
  }
  if (turns_over && turning == TurningOver::Forbidden) return MendOutcome::TurnsOver;
  return n_thin_made > 0 && n_thin_made >= n_thin_gone ? MendOutcome::MakesThin
                                                       : MendOutcome::Possible;
}

void write_changes(const WorkingMesh& mesh, std::span<const FaceChange> faces, MendStep& step) {
  for (const FaceChange& face : faces) {
    if (face.goes) {
      step.changed.push_back({face.number, kNoTriangle});
    } else if (face.corners != mesh.triangle(face.number)) {
      step.changed.push_back({face.number, face.corners});
    }
  }
}

}  // namespace meshalyzer
