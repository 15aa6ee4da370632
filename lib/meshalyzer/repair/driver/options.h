#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/repair/passes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace meshalyzer {

/// Returns all codes except disjoint and numbering.
[[nodiscard]] DefectCodes default_fixes();

/// A maximum deviation: a length, or a share of the diagonal of the mesh's bounding box.
struct Deviation {
  enum class Unit : std::uint8_t { Length, Diagonal };
  double value = 0.001;
  Unit unit = Unit::Diagonal;
};

/// What becomes of copies of a vertex that splitting has left in one place.
enum class Contact : std::uint8_t { Part, Keep };

/// What the borders of an open mesh are.
enum class Borders : std::uint8_t {
  /// Borders are holes, to be filled.
  Holes,
  /// Borders are intended: no hole is filled, and the vertices of borders stay where they are.
  Intended,
};

/// Tells whether all faces are turned over before anything else.
enum class Turn : std::uint8_t { Nothing, Everything };

/// Tells how far a repair is.
struct RepairProgress {
  /// The pass that begins.
  std::string_view pass;
  /// The passes run in rounds until none changes anything; the first round is 1.
  std::size_t round = 1;
  /// The share of the passes of this round that are done.
  double done = 0.0;
};

/// Hears of each pass as it begins. May be empty. Called from the thread that called the library.
using RepairListener = std::function<void(const RepairProgress&)>;

/// What to repair, and how.
struct RepairOptions {
  DefectCodes fixes = default_fixes();
  ToleranceOptions tolerances;
  Deviation max_deviation;
  FillOptions fill;
  /// Joins borders within this length, in addition to the slit tolerance.
  std::optional<double> weld_within;
  Turn turn = Turn::Nothing;
  Contact contact = Contact::Part;
  Borders borders = Borders::Holes;
  Groups groups = Groups::Names;
  /// Tells whether the result is to be a solid: holes of sheets are filled too, and fragments that
  /// bound none are dropped.
  bool solid = false;
  /// Tells whether what is not good in the end is replaced, see guarantee_goodness().
  bool guarantee = false;
  /// Tells how many of the largest components are kept, whatever is lost; 0 keeps all.
  std::size_t keep_largest = 0;
  /// Tells how many remaining defects are listed at most; 0 lists all.
  std::size_t max_defects = 0;
  /// The format of the file that the result will be written to, by default that of the input: the
  /// result is compared with the input as that file holds them.
  std::optional<Format> written_as;
  RepairListener on_progress;
  /// Hears of the input and its defects, with all that is prepared for it, before it is repaired.
  /// May be empty.
  std::function<void(const PreparedMesh&, const DefectReport&)> on_input;
  /// Tells whether RepairedMesh::prepared is kept.
  bool keep_prepared = false;
  /// Whether RepairResult::patches is found.
  bool tells_patches = false;
  /// Asked before each attempt of a pass; once it says yes the repair ends with what it has by
  /// then. May be empty. Called from the thread that called the library.
  std::function<bool()> wants_to_stop;
};

/// Converts a maximum deviation to a length, for a mesh with this box.
///
/// @throws InvalidArgument  where it is negative or not finite.
[[nodiscard]] double length_of(const Deviation& deviation, const Box3& box);

}  // namespace meshalyzer
