#include "meshalyzer/repair/cut/internal/cutting_rounds.h"

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/arrangement/remove_slivers.h"
#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/repair/cut/internal/pairs_to_cut.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/self_intersection_of.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

/// The maximum number of pairs that all rounds may cut, beside this multiple of those of the first.
constexpr std::size_t kMorePairs = 1000;
constexpr std::size_t kTimesFirstPairs = 2;
/// The search for the pairs that rounding makes tests at most this number of pairs of faces, and
/// so many for each new face: among faces that all lie on each other it would test all pairs.
constexpr std::size_t kMoreTests = 2'000'000;
constexpr std::size_t kTestsAFace = 500;
/// The maximum numbers of pieces that are made, and that stay, for each face of the input, beside
/// those that the caller allows. Where solids overlap, most pieces are inside.
constexpr std::size_t kPiecesAFace = 20;
constexpr std::size_t kStayingPiecesAFace = 10;
/// The maximum memory for the digits of exact points, see ArrangeLimits. A million pieces of a mesh
/// whose coordinates have a common scale need two fifths of it, if anything.
constexpr std::size_t kMaxDigitBytes = std::size_t{1} << 27;
/// The maximum number of times that segments cross inside faces, unless there may be even more
/// pieces: 130 faces that all cross each other have as many.
constexpr std::size_t kMaxCrossings = 1'000'000;
/// Slivers are new faces thinner than this multiple of the spacing of the grid. If they widen, each
/// round multiplies their width by a factor, up to a share of the maximum deviation.
constexpr double kSliverWidth = 2.0;
constexpr double kSliverGrowth = 8.0;
constexpr double kWidestSliver = 1.0 / 16.0;
/// It is given up to cut once, after a round, this multiple of its pairs intersect, and some more:
/// then the pairs mostly multiply from round to round, as where many faces have an edge in common.
/// Where slivers are removed, they do so if they become more at all. So many more after the
/// vertices were moved show that the steps were too large for the mesh.
constexpr std::size_t kMostGrowthOfPairs = 8;
constexpr std::size_t kMostGrowthWithoutSlivers = 2;
constexpr std::size_t kMoreThanGrowth = 100;
/// Facets thinner than the tolerance are removed if it is at most this fraction of the maximum
/// deviation, and so many times at most.
constexpr double kLargestTolerance = 0.01;
constexpr int kThinFacetRounds = 4;
/// What intersects after that is cut like in this round, in which vertices become the nearest
/// doubles.
constexpr std::size_t kRoundOfThinFacets = 1;

bool is_flat(const std::vector<Vec3>& positions, const Triangle& t) {
  return are_collinear(corners_of(positions, t));
}

/// Tells whether faces stay as they are in the end.
bool is_left(PieceClass piece_class) {
  return piece_class == PieceClass::Uncut || piece_class == PieceClass::Loose;
}

bool is_exterior(PieceClass piece_class) {
  return piece_class == PieceClass::Exterior || piece_class == PieceClass::PerhapsExterior;
}

bool stays(PieceClass piece_class) {
  return piece_class == PieceClass::Kept || piece_class == PieceClass::Turned ||
         piece_class == PieceClass::OfSheet || is_left(piece_class);
}

/// #components: 1 for those that intersect.
std::vector<std::uint8_t> components_to_select(const Arrangement& arrangement, const Cells& cells,
                                               const std::vector<IntersectingPair>& pairs) {
  std::vector<std::uint8_t> is_cut(cells.n_components, 0);
  for (const IntersectingPair& pair : pairs) {
    for (const Index face : {pair.face_a, pair.face_b}) {
      for (const Index piece : arrangement.pieces_of(face)) {
        is_cut[cells.component_of[piece]] = 1;
      }
    }
  }
  return is_cut;
}

double share_of_pockets(const Arrangement& arrangement, std::span<const PieceClass> classes) {
  double pockets = 0.0;
  double kept = 0.0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (!is_exterior(classes[i]) && !stays(classes[i])) continue;
    (stays(classes[i]) ? kept : pockets) += normal_of(arrangement.corners_of(i)).norm();
  }
  return kept > 0.0 ? pockets / kept : 1.0;
}

std::size_t n_staying(std::span<const PieceClass> classes) {
  return static_cast<std::size_t>(std::count_if(classes.begin(), classes.end(), stays));
}

}  // namespace

CuttingRounds::CuttingRounds(const PassInput& input, const ChangesBefore& changes,
                             const SelectOptions& options, std::size_t more_pieces,
                             FirstCut* first_cut)
    : input_(input),
      mesh_(input.mesh),
      options_(options),
      is_moved_(!changes.positions.empty()),
      max_pieces_(more_pieces + kPiecesAFace * mesh_.soup().n_faces()),
      max_staying_pieces_(more_pieces + kStayingPiecesAFace * mesh_.soup().n_faces()),
      first_cut_(first_cut),
      extent_(used_extent(mesh_.soup())),
      n_pairs_of_round_(changes.n_pairs_in_place),
      parts_(mesh_.soup().n_faces() + changes.patches.size()) {
  options_.wants_to_stop = input.wants_to_stop;
  const std::span<const Vec3> positions = is_moved_ ? changes.positions : mesh_.soup().positions;
  soup_.positions.assign(positions.begin(), positions.end());
  for (const Triangle& t : mesh_.soup().triangles) add(t);
  for (const Edits::AddedFace& patch : changes.patches) add(patch.corners);
}

void CuttingRounds::cut_off_grid() {
  while (has_pairs_ && !(rounding().spacing > 0.0)) has_pairs_ = cut_round();
}

void CuttingRounds::cut_to_end() {
  while (has_pairs_) has_pairs_ = cut_round();
}

void CuttingRounds::remove_slivers_of_rounds(Slivers slivers) {
  removes_slivers_ = true;
  sliver_growth_ = slivers == Slivers::Widening ? kSliverGrowth : 1.0;
}

bool CuttingRounds::remove_thin_facets() {
  const double tolerance = input_.tolerances.degeneracy;
  if (!(tolerance <= kLargestTolerance * input_.limits.max_deviation)) return false;
  for (int i = 0; i < kThinFacetRounds; ++i) {
    RoundedFaces faces = made_faces();
    if (!has_slivers(faces, tolerance)) break;
    remove_slivers(faces, tolerance);
    take(std::move(faces));
    result_.has_removed_facets = true;
    round_ = kRoundOfThinFacets;
    n_pairs_of_round_ = most_pairs_;
    has_pairs_ = cut_round();
    if (!result_.unfinished.empty()) return false;
    if (!has_pairs_) break;
  }
  return result_.has_removed_facets && is_finished();
}

CutSurface CuttingRounds::take_result() {
  result_.positions = std::move(soup_.positions);
  result_.triangles = std::move(soup_.triangles);
  result_.origins = std::move(origins_);
  return std::move(result_);
}

void CuttingRounds::add(const Triangle& t) {
  const Index number = n_added_++;
  if (!is_in_complex(t) || is_flat(soup_.positions, t)) return;
  soup_.triangles.push_back(t);
  origins_.push_back(number);
}

bool CuttingRounds::cut_round() {
  return round_ == 0 ? cut_first_round() : cut_later_round();
}

bool CuttingRounds::cut_first_round() {
  // If nothing was left out, added or moved, all is prepared already.
  if (!is_moved_ && soup_.triangles == mesh_.soup().triangles) {
    return cut_pairs(mesh_.cut(), mesh_.tree(), mesh_.intersecting_pairs());
  }
  const CutMesh cut = build(soup_);
  const FaceTree tree(cut);
  return cut_pairs(cut, tree, find_self_intersections(cut, tree));
}

bool CuttingRounds::cut_later_round() {
  if (new_faces_.empty()) return false;
  const CutMesh cut = build(soup_);
  std::optional<FaceTree> tree;
  if (!*found_) *found_ = search_later_round(cut, tree);
  const FoundPairs& found = **found_;
  if (!found.is_complete) {
    give_up_faces(new_faces_);
    return false;
  }
  if (found.listed.empty()) return false;
  if (!tree) tree.emplace(cut);
  return cut_pairs(cut, *tree, found.listed);
}

FoundPairs CuttingRounds::search_later_round(const CutMesh& cut,
                                             std::optional<FaceTree>& tree) const {
  const PairLimits limits{.max_tested = kMoreTests + kTestsAFace * new_faces_.size(),
                          .wants_to_stop = input_.wants_to_stop};
  if (!is_worth_a_tree(new_faces_.size(), soup_.n_faces())) {
    return find_self_intersections_of(cut, soup_, new_faces_, limits);
  }
  tree.emplace(cut);
  return find_self_intersections_of(cut, *tree, new_faces_, limits);
}

bool CuttingRounds::cut_pairs(const CutMesh& cut, const FaceTree& tree, Pairs pairs) {
  pairs = pairs_to_cut(soup_, cut, tree, std::move(pairs));
  if (pairs.empty()) return false;
  if (round_ == 0) {
    result_.n_first_pairs = pairs.size();
    most_pairs_ = kMorePairs + kTimesFirstPairs * pairs.size();
  }
  n_pairs_cut_ += pairs.size();
  if (round_ == kRoundingRounds || n_pairs_cut_ > most_pairs_ || is_growing(pairs.size()) ||
      input_.wants_to_stop()) {
    give_up(pairs);
    return false;
  }
  cut_once(cut, tree, pairs);
  ++round_;
  return result_.unfinished.empty();
}

bool CuttingRounds::is_growing(std::size_t n_pairs) {
  const std::size_t before = std::exchange(n_pairs_of_round_, n_pairs);
  const std::size_t most = removes_slivers_ ? kMostGrowthWithoutSlivers : kMostGrowthOfPairs;
  return before > 0 && n_pairs > most * before + kMoreThanGrowth;
}

void CuttingRounds::cut_once(const CutMesh& cut, const FaceTree& tree, const Pairs& pairs) {
  const std::shared_ptr<const ArrangedPieces> arranged = arranged_pieces(pairs);
  if (input_.wants_to_stop()) return give_up(pairs);
  result_.has_too_many_pieces = arranged == nullptr;
  if (arranged == nullptr) return give_up(pairs);
  const auto& [arrangement, cells] = *arranged;
  const std::vector<PieceClass> classes =
      select_pieces({soup_, cut, tree, arrangement, cells},
                    components_to_select(arrangement, cells, pairs), options_);
  if (input_.wants_to_stop()) return give_up(pairs);
  result_.has_too_many_pieces = n_staying(classes) > max_staying_pieces_;
  if (result_.has_too_many_pieces) return give_up(pairs);
  tie_faces(arrangement, pairs);
  if (round_ == 0) result_.pocket_share = share_of_pockets(arrangement, classes);
  result_.has_pockets = result_.has_pockets || std::find(classes.begin(), classes.end(),
                                                         PieceClass::Exterior) != classes.end();
  take(arrangement, classes, round_vertices(arrangement, rounding()));
}

std::shared_ptr<const ArrangedPieces> CuttingRounds::arranged_pieces(const Pairs& pairs) {
  FirstCut* const first = round_ == 0 ? first_cut_ : nullptr;
  if (first != nullptr && *first != nullptr) return *first;
  std::optional<Arrangement> arrangement =
      arrange_within(soup_, pairs,
                     {.max_pieces = max_pieces_,
                      .max_digit_bytes = kMaxDigitBytes,
                      .max_crossings = std::max(kMaxCrossings, max_pieces_),
                      .wants_to_stop = input_.wants_to_stop});
  if (!arrangement) return nullptr;
  const auto pieces = std::make_shared<ArrangedPieces>();
  pieces->arrangement = std::move(*arrangement);
  pieces->cells = find_cells(soup_, pieces->arrangement);
  if (first != nullptr) *first = pieces;
  return pieces;
}

Rounding CuttingRounds::rounding() const {
  return rounding_of_round(round_,
                           {.extent = extent_,
                            .max_deviation = input_.limits.max_deviation,
                            .n_input_vertices = static_cast<Index>(mesh_.soup().n_vertices())});
}

double CuttingRounds::sliver_width() {
  const double least = kSliverWidth * rounding().spacing;
  const double grown = least * std::pow(sliver_growth_, n_sliver_rounds_++);
  return std::max(least, std::min(grown, kWidestSliver * input_.limits.max_deviation));
}

void CuttingRounds::tie_faces(const Arrangement& arrangement, const Pairs& pairs) {
  const auto tie = [&](Index a, Index b) {
    if (origins_[a] == origins_[b]) return;
    result_.ties.push_back({origins_[a], origins_[b]});
    parts_.unite(origins_[a], origins_[b]);
  };
  for (const IntersectingPair& pair : pairs) tie(pair.face_a, pair.face_b);
  for (std::size_t i = 0; i < arrangement.pieces.size(); ++i) {
    const auto sources = arrangement.sources_of(i);
    for (const PieceSource& source : sources) tie(sources.front().face, source.face);
  }
}

void CuttingRounds::take(const Arrangement& arrangement, std::span<const PieceClass> classes,
                         RoundedVertices rounded) {
  std::vector<std::uint8_t> was_cut(soup_.n_faces(), 0);
  for (const Index face : arrangement.cut_faces) was_cut[face] = 1;
  RoundedFaces faces;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto sources = arrangement.sources_of(i);
    const Index face = sources.front().face;
    Triangle t = arrangement.pieces[i];
    const bool is_forgotten = is_exterior(classes[i]) && options_.pockets == Pockets::Forgotten;
    const bool is_gone =
        is_forgotten || classes[i] == PieceClass::Interior || classes[i] == PieceClass::Cancelled;
    // The remaining part of one face represents all faces that coincide with it.
    for (const PieceSource& source : sources.subspan(is_gone ? 0 : 1)) {
      add_wall(source.face, arrangement, i);
    }
    if (was_cut[face] != 0) note_sheets(origins_[face], classes[i]);
    if (!stays(classes[i])) continue;
    for (Index& v : t) v = rounded.stands_for[v];
    const bool is_moved = t != arrangement.pieces[i];
    if (classes[i] == PieceClass::Turned) std::swap(t[1], t[2]);
    const bool is_changed = was_cut[face] != 0 || is_moved;
    if (is_changed && (!is_in_complex(t) || is_flat(rounded.positions, t))) {
      add_wall(face, arrangement, i);
      continue;
    }
    faces.triangles.push_back(t);
    faces.ages.push_back(is_changed ? FaceAge::New : FaceAge::Old);
    faces.origins.push_back(origins_[face]);
  }
  faces.positions = std::move(rounded.positions);
  skip_left_parts(faces);
  if (removes_slivers_) remove_slivers(faces, sliver_width());
  take(std::move(faces));
}

void CuttingRounds::skip_left_parts(RoundedFaces& faces) {
  std::vector<std::uint8_t> is_left_part(n_added_, 0);
  for (const Index face : result_.of_uncut_sheets) is_left_part[parts_.find(face)] = 1;
  for (const Index face : result_.loose) is_left_part[parts_.find(face)] = 1;
  for (std::size_t i = 0; i < faces.origins.size(); ++i) {
    if (is_left_part[parts_.find(faces.origins[i])] != 0) faces.ages[i] = FaceAge::Old;
  }
}

void CuttingRounds::take(RoundedFaces faces) {
  soup_.positions = std::move(faces.positions);
  soup_.triangles = std::move(faces.triangles);
  origins_ = std::move(faces.origins);
  new_faces_.clear();
  for (Index face = 0; face < faces.ages.size(); ++face) {
    if (faces.ages[face] == FaceAge::New) new_faces_.push_back(face);
  }
  found_ = std::make_shared<std::optional<FoundPairs>>();
}

RoundedFaces CuttingRounds::made_faces() {
  RoundedFaces faces{.positions = soup_.positions,
                     .triangles = soup_.triangles,
                     .ages = std::vector(soup_.n_faces(), FaceAge::Searched),
                     .origins = origins_};
  const std::vector<Triangle>& input = mesh_.soup().triangles;
  for (Index face = 0; face < soup_.n_faces(); ++face) {
    const bool is_of_input =
        origins_[face] < input.size() && input[origins_[face]] == soup_.triangles[face];
    if (is_of_input) faces.ages[face] = FaceAge::Old;
  }
  if (has_pairs_) {
    for (const Index face : new_faces_) faces.ages[face] = FaceAge::New;
  }
  skip_left_parts(faces);
  return faces;
}

void CuttingRounds::note_sheets(Index origin, PieceClass piece_class) {
  if (piece_class == PieceClass::OfSheet) result_.of_sheets.push_back(origin);
  if (piece_class == PieceClass::Uncut) result_.of_uncut_sheets.push_back(origin);
  if (piece_class == PieceClass::Loose) result_.loose.push_back(origin);
}

void CuttingRounds::add_wall(Index face, const Arrangement& arrangement, std::size_t piece) {
  result_.walls.push_back({arrangement.corners_of(piece), origins_[face]});
}

void CuttingRounds::give_up(const Pairs& pairs) {
  std::vector<Index> faces;
  for (const IntersectingPair& pair : pairs) {
    faces.insert(faces.end(), {pair.face_a, pair.face_b});
  }
  give_up_faces(faces);
}

void CuttingRounds::give_up_faces(std::span<const Index> faces) {
  for (const Index face : faces) result_.unfinished.push_back(origins_[face]);
  sort_unique(result_.unfinished);
}

}  // namespace meshalyzer
