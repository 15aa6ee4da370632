#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/arrangement/round_vertices.h"
#include "meshalyzer/arrangement/rounded_faces.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// The new faces that are removed as slivers where rounding makes faces intersect again and again.
enum class Slivers : std::uint8_t {
  /// Those that the grid makes: their width is about its spacing.
  OfGrid,
  /// Wider ones from round to round, up to a share of the maximum deviation. That ends more often,
  /// and moves the surface farther.
  Widening,
};

/// A surface that was cut once, exactly.
struct ArrangedPieces {
  Arrangement arrangement;
  Cells cells;
};

/// The first cut of a surface, for all that cut the same surface; null until one has cut it.
using FirstCut = std::shared_ptr<const ArrangedPieces>;

/// Cuts a surface, round by round. A copy is a state to which one can return.
class CuttingRounds {
 public:
  /// The arguments are those of cut_surface().
  ///
  /// @param input      Must outlive the rounds and all copies.
  /// @param first_cut  Is used instead of cutting, or receives the first cut if there is none yet;
  ///                   it must outlive the rounds and all copies. May be null.
  CuttingRounds(const PassInput& input, const ChangesBefore& changes, const SelectOptions& options,
                std::size_t more_pieces, FirstCut* first_cut = nullptr);

  /// Cuts until no pairs are left to cut, or the vertices are to be rounded to a grid.
  void cut_off_grid();

  /// Cuts until no pairs are left to cut, or it is given up.
  void cut_to_end();

  [[nodiscard]] bool has_pairs() const { return has_pairs_; }
  [[nodiscard]] bool is_finished() const { return !has_pairs_ && result_.unfinished.empty(); }
  /// See CutSurface.
  [[nodiscard]] bool has_too_many_pieces() const { return result_.has_too_many_pieces; }
  [[nodiscard]] double pocket_share() const { return result_.pocket_share; }

  /// From now on, slivers are removed after each round.
  void remove_slivers_of_rounds(Slivers slivers);

  /// Removes facets below the tolerance that cutting has made, and cuts where faces intersect
  /// because of that, without a grid: it would only make more of them.
  ///
  /// @return Whether there were any, and all that were to be cut could be cut.
  bool remove_thin_facets();

  CutSurface take_result();

 private:
  using Pairs = std::vector<IntersectingPair>;

  void add(const Triangle& t);

  // The next four functions tell whether another round is needed.

  /// Searches for intersecting pairs and cuts them.
  bool cut_round();
  /// Searches among all faces.
  bool cut_first_round();
  /// Cuts what the new faces intersect, and searches for it first if no copy has.
  bool cut_later_round();
  /// Returns what the new faces intersect.
  ///
  /// @param tree  Receives a tree over all faces if the search has built one.
  [[nodiscard]] FoundPairs search_later_round(const CutMesh& cut,
                                              std::optional<FaceTree>& tree) const;
  /// Cuts those of the pairs that are to be cut, or gives it up.
  bool cut_pairs(const CutMesh& cut, const FaceTree& tree, Pairs pairs);

  /// Tells whether the pairs become so many more that another round only makes it worse.
  bool is_growing(std::size_t n_pairs);
  void cut_once(const CutMesh& cut, const FaceTree& tree, const Pairs& pairs);
  /// Returns the exact pieces of this round; null if they are too many.
  [[nodiscard]] std::shared_ptr<const ArrangedPieces> arranged_pieces(const Pairs& pairs);

  /// The rounding of new vertices in this round.
  [[nodiscard]] Rounding rounding() const;
  /// Returns the width below which the faces that this round has made are slivers.
  double sliver_width();

  /// Notes which parts of the input change together.
  void tie_faces(const Arrangement& arrangement, const Pairs& pairs);
  void take(const Arrangement& arrangement, std::span<const PieceClass> classes,
            RoundedVertices rounded);
  /// Takes the faces for the surface of the next round.
  void take(RoundedFaces faces);
  /// Takes faces for no new ones if their part of the input is left as a whole, because a face of
  /// it is left: nothing is gained by cutting them on.
  void skip_left_parts(RoundedFaces& faces);
  /// Returns the faces of the surface; those of the input are old.
  [[nodiscard]] RoundedFaces made_faces();
  void note_sheets(Index origin, PieceClass piece_class);
  void add_wall(Index face, const Arrangement& arrangement, std::size_t piece);
  void give_up(const Pairs& pairs);
  void give_up_faces(std::span<const Index> faces);

  const PassInput& input_;
  const PreparedMesh& mesh_;
  SelectOptions options_;
  /// Tells whether vertices are elsewhere than in the mesh.
  bool is_moved_;
  std::size_t max_pieces_;
  std::size_t max_staying_pieces_;
  FirstCut* first_cut_;
  double extent_;
  bool has_pairs_ = true;
  std::size_t round_ = 0;
  std::size_t n_pairs_cut_ = 0;
  /// The number of pairs of the last round; at first ChangesBefore::n_pairs_in_place.
  std::size_t n_pairs_of_round_;
  std::size_t most_pairs_ = 0;
  Index n_added_ = 0;
  /// The faces of the input, in sets that change together.
  DisjointSets parts_;
  /// The surface that is cut in this round: positions and faces alone.
  Soup soup_;
  std::vector<Index> origins_;
  /// The faces that the last round has made, ascending, without those that are left.
  std::vector<Index> new_faces_;
  /// What they intersect, once it is known. Copies have it in common as long as they have the same
  /// surface, so that only one of them searches.
  std::shared_ptr<std::optional<FoundPairs>> found_;
  bool removes_slivers_ = false;
  double sliver_growth_ = 1.0;
  int n_sliver_rounds_ = 0;
  CutSurface result_;
};

}  // namespace meshalyzer
