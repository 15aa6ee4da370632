#pragma once

#include "meshalyzer/base/progress.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/trial/repair_log.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// All codes but disjoint and numbering.
[[nodiscard]] DefectCodes default_fixes();

/// A length, or a share of the diagonal of the mesh's bounding box.
struct Deviation {
  enum class Unit : std::uint8_t { Length, Diagonal };
  double value = 0.001;
  Unit unit = Unit::Diagonal;
};

/// What becomes of copies of a vertex that splitting has left in one place.
enum class Contact : std::uint8_t { Part, Keep };

/// What the borders of an open mesh are.
enum class Borders : std::uint8_t {
  /// Holes, to be filled.
  Holes,
  /// Meant: no hole is filled, and their vertices stay where they are.
  Meant,
};

/// Whether every face is turned over, first of all.
enum class Turn : std::uint8_t { Nothing, Everything };

struct RepairOptions {
  DefectCodes fixes = default_fixes();
  ToleranceOptions tolerances;
  Deviation max_deviation;
  FillOptions fill;
  /// Joins borders within this length, besides what the slit tolerance says; asked for by name.
  std::optional<double> weld_within;
  Turn turn = Turn::Nothing;
  Contact contact = Contact::Part;
  Borders borders = Borders::Holes;
  Groups groups = Groups::Names;
  /// Only so many of the largest components come out, whatever is lost; 0: all.
  std::size_t keep_largest = 0;
  /// List so many remaining defects at most, 0: all.
  std::size_t max_defects = 0;
  PhaseListener on_phase;
};

/// What came out.
struct RepairedMesh {
  Draft draft;
  /// What still is wrong with it.
  DefectReport remaining;
};

struct RepairResult {
  /// What was wrong with the input.
  DefectReport before;
  /// One, or, where disjoint is to be fixed, one a component, see separate().
  std::vector<RepairedMesh> meshes;
  RepairLog log;
  /// The bound that was kept, and an upper bound of what was measured; in the mesh's unit. Hole
  /// patches, and what later passes make of them together with what is round them, are left out.
  double max_deviation = 0.0;
  double deviation = 0.0;
};

/// Repairs a mesh as far as it can be, within a deviation, and says what remains (contract 6).
///
/// What is not broken stays bit for bit. Repairing the result again changes nothing.
///
/// @throws InvalidArgument  as resolve_tolerances(); for a deviation that is negative or not
/// finite; and where a position is not finite.
[[nodiscard]] RepairResult fix_defects(Soup soup, const RepairOptions& options = {});

}  // namespace meshalyzer
