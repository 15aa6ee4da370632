#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace meshalyzer {

/// Returns all codes except disjoint and numbering.
[[nodiscard]] DefectCodes default_fixes();

/// A maximum deviation: a length, or a share of the diagonal of the mesh's bounding box. Its value
/// is finite and not negative.
struct Deviation {
  enum class Unit : std::uint8_t { Length, Diagonal };
  double value = 0.001;
  Unit unit = Unit::Diagonal;
};

/// The treatment of copies of a vertex that splitting has left at one position.
enum class Contact : std::uint8_t { Part, Keep };

/// The treatment of the borders of an open mesh.
enum class Borders : std::uint8_t {
  /// Borders are holes, which are filled.
  Holes,
  /// Borders are intended: no hole is filled, and the vertices of borders stay where they are.
  Intended,
};

/// Tells whether all faces are turned over before any other repair.
enum class Turn : std::uint8_t { Nothing, Everything };

/// The progress of a repair.
struct RepairProgress {
  /// The name of the pass that begins.
  std::string_view pass;
  /// The number of the round, from 1. The passes run in rounds until none changes anything.
  std::size_t round = 1;
  /// The fraction of the passes of this round that are done.
  double done = 0.0;
};

/// Receives the progress as each pass begins. May be empty. It is called from the thread that
/// called the library.
using RepairListener = std::function<void(const RepairProgress&)>;

/// The options of a repair: what to repair, and how.
struct RepairOptions {
  DefectCodes fixes = default_fixes();
  ToleranceOptions tolerances;
  Deviation max_deviation;
  FillOptions fill;
  /// Joins borders within this length, in addition to those within the slit tolerance. It is finite
  /// and not negative.
  std::optional<double> weld_within;
  Turn turn = Turn::Nothing;
  Contact contact = Contact::Part;
  Borders borders = Borders::Holes;
  Groups groups = Groups::Names;
  /// Tells whether the result is to be a solid: the holes of sheets are filled too, and fragments
  /// that bound no solid are dropped.
  bool solid = false;
  /// Tells whether parts that are still not good after the passes are replaced, see
  /// guarantee_goodness().
  bool guarantee = false;
  /// Tells how many of the largest components are kept, whatever is lost; 0 keeps all.
  std::size_t keep_largest = 0;
  /// The largest number of intersecting pairs of a mesh that is repaired: one with more is left as
  /// it is, so that memory stays bounded. By default it is four million, or 32 a face.
  std::optional<std::size_t> max_pairs;
  /// Tells how many remaining defects are listed at most; 0 lists all.
  std::size_t max_defects = 0;
  /// The format of the file that the result will be written to, by default that of the input. The
  /// result is compared with the input as a file of that format holds them.
  std::optional<Format> written_as;
  RepairListener on_progress;
  /// Receives the input and its defects, with all data that is prepared for it, before the repair.
  /// It may keep the mesh. May be empty.
  std::function<void(std::shared_ptr<const PreparedMesh>, const DefectReport&)> on_input;
  /// Tells whether RepairedMesh::prepared is kept.
  bool keep_prepared = false;
  /// Tells whether RepairResult::patches is computed.
  bool reports_patches = false;
  /// Called before each attempt of a pass and within those that take long, from any thread. Once it
  /// returns true it must go on to do so, and the repair ends with the mesh that it has reached.
  StopQuery wants_to_stop;
};

/// Converts a maximum deviation to a length, for a mesh with this box.
///
/// @throws InvalidArgument  if it is negative or not finite.
[[nodiscard]] double length_of(const Deviation& deviation, const Box3& box);

/// Returns the limits of a search for the intersecting pairs of a mesh that is to be repaired, see
/// RepairOptions::max_pairs and wants_to_stop.
[[nodiscard]] PairLimits pair_limits(const RepairOptions& options, std::size_t n_faces);

}  // namespace meshalyzer
