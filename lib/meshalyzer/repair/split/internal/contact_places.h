#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "meshalyzer/repair/split/internal/incident_faces.h"

#include <array>
#include <vector>

namespace meshalyzer {

// The positions where faces touch that were cut apart.

/// Vertices at one position whose faces touch there, though no border edges could be welded.
struct ContactPlace {
  /// The units: vertices that move together, mostly one. A unit has several if border edges at the
  /// same position, which weld_borders() is to join, connect them. Each is ascending; they are in
  /// order of their lowest vertices.
  std::vector<std::vector<Index>> units;
  /// Pairs of units, by number, whose faces touch; ascending.
  std::vector<std::array<Index, 2>> contacts;
};

struct ContactPlaces {
  /// The vertices of all units.
  IncidentFaces incident;
  /// The places in order of their lowest vertices.
  std::vector<ContactPlace> places;
};

/// Finds the positions where faces touch that would not if vertices at identical positions were
/// one: pairs of kind Unwelded, and faces that coincide with all three corners.
///
/// @param mesh  Prepared from tracked.soup.
[[nodiscard]] ContactPlaces find_contact_places(const TrackedMesh& tracked,
                                                const PreparedMesh& mesh);

}  // namespace meshalyzer
