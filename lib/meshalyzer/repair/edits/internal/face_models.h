#pragma once

#include "meshalyzer/io/rewrite/blend.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/internal/edited_faces.h"
#include "meshalyzer/repair/edits/internal/skipped_operations.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// The old faces from which the faces after edits take their normals. It only refers to its
/// arguments.
class FaceModels {
 public:
  FaceModels(const Soup& before, const Edits& edits, const SkippedOperations& skipped,
             const EditedFaces& faces);

  [[nodiscard]] const Soup& before() const { return before_; }
  [[nodiscard]] const Edits& edits() const { return edits_; }
  /// The faces after the edits, whose corners are numbered as in Edits.
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return faces_.triangles; }

  /// Tells whether a face is an old one, with the same or other corners.
  [[nodiscard]] bool is_old(std::size_t face) const;
  /// Tells whether a face is part of a hole patch, which takes no normals from others.
  [[nodiscard]] bool is_patch(std::size_t face) const;
  /// The old face that a face is or is modelled on.
  [[nodiscard]] Index model_of(std::size_t face) const;
  /// Tells whether the normals of the model are turned over.
  [[nodiscard]] bool turns_normals(std::size_t face) const { return turns_[face] != 0; }
  /// Returns the old vertex that a corner is, or is a copy of; kNoIndex for a new one.
  [[nodiscard]] Index old_vertex(Index corner) const;
  /// Returns the place of a vertex, that of an old one before the edits.
  [[nodiscard]] const Vec3& place_of(Index corner) const;
  /// Returns the places of the corners of a face, none of which may be missing.
  [[nodiscard]] Corners places_of(std::size_t face) const;

  /// Returns the normal that a new corner of a face, numbered as in Edits, takes from the model, in
  /// the orientation of that: the weighted mean of its normals, at the point that is nearest to the
  /// corner, or the direction of the face if that is opposed to it. Nothing if the model lacks
  /// normals.
  [[nodiscard]] std::optional<Vec3> normal_at(std::size_t face, Index corner) const;

 private:
  [[nodiscard]] const Edits::AddedFace& added(std::size_t face) const;
  /// Tells whether a face faces the other way than its model.
  [[nodiscard]] bool is_reversed(std::size_t face) const;
  /// Returns the unit normal of a face, before the edits move its vertices.
  [[nodiscard]] Vec3 direction_of(std::size_t face) const;
  [[nodiscard]] Vec3 blended(const Blend& blend) const;

  const Soup& before_;
  const Edits& edits_;
  const EditedFaces& faces_;
  /// By face: non-zero if the normals of its model are turned over.
  std::vector<std::uint8_t> turns_;
};

}  // namespace meshalyzer
