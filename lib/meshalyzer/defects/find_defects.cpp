#include "meshalyzer/defects/find_defects.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/mesh/require_records.h"
#include "meshalyzer/mesh/used_box.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// The defects that were found, by code.
class Findings {
 public:
  [[nodiscard]] DefectList& operator[](DefectCode code) {
    return lists_[static_cast<std::size_t>(code)];
  }

 private:
  std::array<DefectList, kDefectCodes> lists_;
};

/// Runs the finders of the codes that are asked for.
class Search {
 public:
  Search(const DefectOptions& options, const Tolerances& tolerances)
      : codes_(options.codes), tolerances_(tolerances), wants_to_stop_(options.wants_to_stop) {}

  /// Runs the finders that need only the records, not the positions of vertices.
  void search_records(const Soup& soup) {
    add(DefectCode::Corrupt, [&] { return find_corrupt(soup); });
    add(DefectCode::OrphanVertex, [&] { return find_orphans(soup); });
    add(DefectCode::Numbering, [&] { return find_numbering(soup); });
    run_at_once(soup.n_vertices() + soup.n_faces());
  }

  void search_mesh(const PreparedMesh& mesh) {
    add(DefectCode::Disjoint, [&] { return find_disjoint(mesh); });
    add(DefectCode::NonManifold, [&] { return find_non_manifold(mesh); });
    add(DefectCode::VertexNormal, [&] { return find_opposed_normals(mesh); });
    add(DefectCode::Flipped, [&] { return find_flipped(mesh); });
    add(DefectCode::DuplicateFacet, [&] { return find_duplicate_facets(mesh); });
    if (asks(DefectCode::FlatFacet) || asks(DefectCode::DegenerateFacet)) {
      finders_.emplace_back([&] { search_thin_facets(mesh); });
    }
    run_at_once(mesh.cut().mesh.n_faces());
    search_positions(mesh);
  }

  [[nodiscard]] Findings take() { return std::move(findings_); }
  /// Tells whether a search was told to stop.
  [[nodiscard]] bool was_stopped() const { return was_stopped_; }

 private:
  bool is_to_stop() {
    was_stopped_ = was_stopped_ || wants_to_stop_();
    return was_stopped_;
  }

  [[nodiscard]] bool asks(DefectCode code) const { return codes_.contains(code); }

  template <typename Finder>
  void add(DefectCode code, Finder finder) {
    if (asks(code)) finders_.emplace_back([this, code, finder] { findings_[code] = finder(); });
  }

  /// Runs the finders that search in space, in parallel each.
  void search_positions(const PreparedMesh& mesh) {
    if (asks(DefectCode::Foldover)) {
      findings_[DefectCode::Foldover] =
          find_foldovers(mesh, tolerances_, [this] { return is_to_stop(); });
    }
    // Two of the others need the intersecting pairs: if these were not known, one would wait.
    if (asks(DefectCode::SelfIntersection)) static_cast<void>(mesh.intersecting_pairs());
    add(DefectCode::SelfIntersection, [&] { return find_self_intersection_patches(mesh); });
    add(DefectCode::Inward, [&] { return find_inward(mesh); });
    if (asks(DefectCode::Slit) || asks(DefectCode::Hole)) {
      finders_.emplace_back([&] { search_borders(mesh); });
    }
    run_at_once(mesh.cut().mesh.n_faces());
  }

  void search_thin_facets(const PreparedMesh& mesh) {
    for (const Defect& defect : find_thin_facets(mesh, tolerances_)) {
      if (asks(defect.code)) findings_[defect.code].push_back(defect);
    }
  }

  void search_borders(const PreparedMesh& mesh) {
    DefectList slits = find_slits(mesh, tolerances_);
    if (asks(DefectCode::Hole)) findings_[DefectCode::Hole] = find_holes(mesh, slits);
    if (asks(DefectCode::Slit)) findings_[DefectCode::Slit] = std::move(slits);
  }

  void run_at_once(std::size_t n_items) { parallel_invoke(n_items, std::exchange(finders_, {})); }

  const DefectCodes& codes_;
  const Tolerances& tolerances_;
  const StopQuery& wants_to_stop_;
  bool was_stopped_ = false;
  std::vector<std::function<void()>> finders_;
  Findings findings_;
};

DefectReport make_report(Findings findings, Tolerances tolerances, std::size_t max_defects) {
  DefectReport report;
  for (const DefectCode code : all_defect_codes()) {
    DefectList& found = findings[code];
    report.counts[static_cast<std::size_t>(code)] = found.size();
    const std::size_t room = max_defects == 0 ? found.size() : max_defects - report.defects.size();
    const std::size_t n = std::min(room, found.size());
    report.defects.append(std::exchange(found, {}), n);
  }
  report.tolerances = tolerances;
  report.warnings = inconsistencies(tolerances);
  return report;
}

/// @param mesh  The mesh, or null if it cannot be built because positions are not finite.
DefectReport find_in(const Soup& soup, const PreparedMesh* mesh, const DefectOptions& options) {
  const Box3 box = mesh != nullptr ? used_box(soup) : Box3();
  const Tolerances tolerances = resolve_tolerances(options.tolerances, box);
  Search search(options, tolerances);
  search.search_records(soup);
  if (mesh != nullptr) search.search_mesh(*mesh);
  DefectReport report = make_report(search.take(), tolerances, options.max_defects);
  if (mesh != nullptr && mesh->was_intersection_search_cut()) {
    report.unfinished.insert(DefectCode::SelfIntersection);
    // A single component is in no other, so that its direction depends on no pair.
    const bool may_nest = mesh->components().count > 1;
    if (may_nest) report.unfinished.insert(DefectCode::Inward);
    report.warnings.push_back(
        std::string("the search for intersecting faces ended early: there may be more "
                    "self-intersections") +
        (may_nest ? ", and inward components," : "") + " than are listed");
  }
  if (search.was_stopped()) {
    report.unfinished.insert(DefectCode::Foldover);
    report.warnings.emplace_back(
        "the search for foldovers ended early: there may be more than are listed");
  }
  return report;
}

}  // namespace

std::size_t DefectReport::count(const DefectCodes& codes) const {
  std::size_t n = 0;
  for (const DefectCode code : all_defect_codes()) {
    if (codes.contains(code)) n += count(code);
  }
  return n;
}

bool DefectReport::may_have_more(const DefectCodes& codes) const {
  const auto& all = all_defect_codes();
  return std::any_of(all.begin(), all.end(), [&](DefectCode code) {
    return codes.contains(code) && unfinished.contains(code);
  });
}

std::size_t DefectReport::total() const {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

DefectReport find_defects(const Soup& soup, const DefectOptions& options) {
  if (!has_finite_positions(soup)) {
    require_records(soup);
    return find_in(soup, nullptr, options);
  }
  const PreparedMesh mesh(soup, options.pairs);
  return find_in(soup, &mesh, options);
}

DefectReport find_defects(const PreparedMesh& mesh, const DefectOptions& options) {
  return find_in(mesh.soup(), has_finite_positions(mesh.soup()) ? &mesh : nullptr, options);
}

}  // namespace meshalyzer
