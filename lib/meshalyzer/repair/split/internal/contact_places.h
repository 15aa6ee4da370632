#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/split/internal/incident_faces.h"

#include <array>
#include <vector>

namespace meshalyzer {

// Private to part_contacts(): where faces touch that were cut apart.

/// Vertices at one place whose faces touch there, though no border edges could be welded.
struct ContactPlace {
  /// Vertices that move together: mostly one; several where border edges at the same place join
  /// them, which are for weld_borders(). Each ascending, in order of their lowest vertices.
  std::vector<std::vector<Index>> units;
  /// Pairs of units, by number, whose faces touch; ascending.
  std::vector<std::array<Index, 2>> contacts;
};

struct ContactPlaces {
  /// The vertices of all units.
  IncidentFaces incident;
  /// In order of their lowest vertices.
  std::vector<ContactPlace> places;
};

/// Finds the places where faces touch that would not if vertices at identical places were one:
/// pairs of kind Unwelded, and faces that lie on each other with all three corners.
[[nodiscard]] ContactPlaces find_contact_places(const PreparedMesh& mesh);

}  // namespace meshalyzer
