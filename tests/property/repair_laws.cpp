#include "repair_laws.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/mesh/validate.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "plain_counts.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "support/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The elements that a log names, by key.
struct Named {
  std::set<Index> removed_faces, added_faces, changed_faces;
  std::set<Index> removed_vertices, added_vertices, moved_vertices;
};

Named named_in(const RepairLog& log) {
  Named named;
  const auto add = [](std::set<Index>& to, const std::vector<Index>& keys) {
    to.insert(keys.begin(), keys.end());
  };
  for (const LoggedOperation& operation : log.operations) {
    add(named.removed_faces, operation.removed_faces);
    add(named.added_faces, operation.added_faces);
    add(named.changed_faces, operation.changed_faces);
    add(named.removed_vertices, operation.removed_vertices);
    add(named.added_vertices, operation.added_vertices);
    add(named.moved_vertices, operation.moved_vertices);
  }
  return named;
}

/// Keys below n that are not in a list are said to be gone, those beyond are said to be new, and
/// none twice.
void expect_named(const std::vector<Index>& keys, std::size_t n, const std::set<Index>& removed,
                  const std::set<Index>& added) {
  const std::set<Index> present(keys.begin(), keys.end());
  EXPECT_EQ(present.size(), keys.size());
  for (Index key = 0; key < n; ++key) {
    EXPECT_EQ(!present.contains(key), removed.contains(key)) << "input's element " << key;
  }
  for (const Index key : present) {
    if (key >= n) {
      EXPECT_TRUE(added.contains(key)) << "new element " << key;
    }
  }
}

bool is_same_place(const Vec3& p, const Vec3& q) {
  return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
}

std::string group_name(const Soup& soup, Index face) {
  const Index group = group_of(soup, face);
  return group == kNoIndex ? "" : soup.groups[group].name;
}

/// The three corners by key, from the one where the face begins.
Triangle corner_keys(const TrackedMesh& tracked, Index face) {
  Triangle corners = tracked.soup.triangles[face];
  for (Index& v : corners) v = v == kNoIndex ? kNoIndex : tracked.vertex_keys[v];
  return corners;
}

bool has_step(const RepairLog& log, DefectCode code) {
  return std::any_of(log.steps.begin(), log.steps.end(),
                     [&](const LogStep& step) { return step.code == code; });
}

void expect_vertices_untouched(const Soup& input, const RepairResult& result, const Named& named) {
  const TrackedMesh& tracked = result.meshes.front().tracked;
  const bool is_renumbered = has_step(result.log, DefectCode::Numbering);
  for (Index v = 0; v < tracked.soup.n_vertices(); ++v) {
    const Index key = tracked.vertex_keys[v];
    if (key >= tracked.n_input_vertices || named.moved_vertices.contains(key)) continue;
    EXPECT_TRUE(is_same_place(tracked.soup.positions[v], input.positions[key])) << "vertex " << key;
    if (tracked.soup.format == Format::Mesh && !is_renumbered) {
      EXPECT_EQ(tracked.soup.vertex_ids.of(v), input.vertex_ids.of(key)) << "vertex " << key;
    }
  }
}

void expect_normals_untouched(const Soup& input, const TrackedMesh& tracked, Index face) {
  const Index key = tracked.face_keys[face];
  if (input.corner_normals.empty()) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index was = input.corner_normals[key][k];
    const Index is = tracked.soup.corner_normals[face][k];
    ASSERT_EQ(was == kNoIndex, is == kNoIndex);
    if (was != kNoIndex) {
      EXPECT_TRUE(is_same_place(input.normals[was], tracked.soup.normals[is])) << "face " << key;
    }
  }
}

/// By face key: whether it is a hole patch, or was made of one together with what is round it.
std::set<Index> patch_keys(const RepairResult& result) {
  const TrackedMesh& tracked = result.meshes.front().tracked;
  std::set<Index> keys;
  for (std::size_t i = 0; i < tracked.face_origins.size(); ++i) {
    if (tracked.face_origins[i] == kNoIndex)
      keys.insert(static_cast<Index>(tracked.n_input_faces + i));
  }
  for (const LoggedOperation& operation : result.log.operations) {
    const auto fills_hole = [&](Index key) { return keys.contains(key); };
    const auto has_patch = [&](const std::vector<Index>& faces) {
      return std::any_of(faces.begin(), faces.end(), fills_hole);
    };
    if (!has_patch(operation.removed_faces) && !has_patch(operation.changed_faces)) continue;
    keys.insert(operation.changed_faces.begin(), operation.changed_faces.end());
    keys.insert(operation.added_faces.begin(), operation.added_faces.end());
  }
  return keys;
}

Soup without_patches(const RepairResult& result) {
  const TrackedMesh& tracked = result.meshes.front().tracked;
  const std::set<Index> patches = patch_keys(result);
  Soup soup = tracked.soup;
  std::vector<Triangle> kept;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (!patches.contains(tracked.face_keys[f])) kept.push_back(soup.triangles[f]);
  }
  soup.triangles = std::move(kept);
  return soup;
}

/// Adds the intersecting pairs to the plain counts; touching copies are no pairs where they are to
/// be kept.
PlainCounts count_all(const Soup& soup, const RepairOptions& options) {
  PlainCounts counts = count_plainly(soup);
  const PreparedMesh mesh(soup);
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    const bool counts_here = options.contact != Contact::Keep || pair.kind != ContactKind::Unwelded;
    counts["intersecting pairs"] += counts_here ? 1 : 0;
  }
  return counts;
}

/// Counts the edges with one face that have an end where a sheet was cut.
std::size_t count_borders_of_cut_sheets(const TrackedMesh& tracked) {
  std::map<std::pair<Index, Index>, std::size_t> n_faces;
  for (const Triangle& t : tracked.soup.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++n_faces[std::minmax({t[k], t[(k + 1) % 3]})];
  }
  const auto is_cut = [&](Index v) {
    return std::find(tracked.sheet_cuts.begin(), tracked.sheet_cuts.end(),
                     tracked.vertex_keys[v]) != tracked.sheet_cuts.end();
  };
  return static_cast<std::size_t>(
      std::count_if(n_faces.begin(), n_faces.end(), [&](const auto& edge) {
        return edge.second == 1 && (is_cut(edge.first.first) || is_cut(edge.first.second));
      }));
}

bool is_outward(const Soup& soup) {
  const PreparedMesh mesh(soup);
  const std::vector<Shell>& shells = mesh.shells();
  return !shells.empty() && std::all_of(shells.begin(), shells.end(), [](const Shell& shell) {
    return shell.outward.value_or(false);
  });
}

}  // namespace

void expect_never_worse(const Soup& input, const RepairResult& result,
                        const RepairOptions& options) {
  ASSERT_EQ(result.meshes.size(), 1U);
  const Soup& soup = result.meshes.front().tracked.soup;
  PlainCounts before = count_all(input, options);
  PlainCounts after = count_all(soup, options);
  const std::size_t parted = before["non-manifold edges"] -
                             std::min(before["non-manifold edges"], after["non-manifold edges"]);
  const bool fewer_intersect = after["intersecting pairs"] < before["intersecting pairs"];
  const std::size_t cut_off =
      fewer_intersect ? count_borders_of_cut_sheets(result.meshes.front().tracked) : 0;
  for (const auto& [name, n] : after) {
    const bool is_border = name == "border edges";
    const bool is_left_by_parting = is_border || name == "pinched vertices";
    EXPECT_LE(n, before[name] + (is_left_by_parting ? parted : 0) + (is_border ? cut_off : 0))
        << name;
  }
  for (const char* name : {"border edges", "non-manifold vertices"}) {
    if (before[name] == 0) {
      EXPECT_EQ(after[name], 0U) << name;
    }
  }
  const bool turns = options.turn == Turn::Everything;
  if (!turns && before["border edges"] == 0 && is_outward(input)) {
    EXPECT_TRUE(is_outward(soup));
  }
}

void expect_done(const RepairResult& result, const RepairOptions& options) {
  RepairOptions again = options;
  again.turn = Turn::Nothing;
  for (const RepairedMesh& mesh : result.meshes) {
    const RepairResult second = fix_defects(mesh.tracked.soup, again);
    EXPECT_TRUE(second.log.operations.empty())
        << "second run: " << second.log.steps.front().pass << ", " << second.log.operations.size()
        << " operations";
    ASSERT_EQ(second.meshes.size(), 1U);
    EXPECT_TRUE(same_soup(second.meshes.front().tracked.soup, mesh.tracked.soup));
  }
}

void expect_reasons(const RepairResult& result, const RepairOptions& options) {
  std::set<DefectCode> refused;
  if (options.borders == Borders::Intended) refused.insert(DefectCode::Hole);
  for (const LoggedRefusal& refusal : result.log.refusals) {
    refused.insert(refusal.code);
    EXPECT_FALSE(refusal.reason.empty());
    EXPECT_FALSE(refusal.pass.empty());
  }
  for (const RepairedMesh& mesh : result.meshes) {
    for (const DefectCode code : all_defect_codes()) {
      // Those there were may stay, and faces that touch are named above.
      if (code == DefectCode::SelfIntersection || !options.fixes.contains(code)) continue;
      EXPECT_TRUE(mesh.remaining.count(code) == 0 || refused.contains(code))
          << defect_name(code) << " remains: " << mesh.remaining.count(code) << " of "
          << result.before.count(code) << ", and nobody says why";
    }
  }
}

void expect_log_complete(const Soup& input, const RepairResult& result) {
  ASSERT_EQ(result.meshes.size(), 1U);
  const TrackedMesh& tracked = result.meshes.front().tracked;
  const Named named = named_in(result.log);
  {
    SCOPED_TRACE("faces");
    expect_named(tracked.face_keys, input.n_faces(), named.removed_faces, named.added_faces);
  }
  SCOPED_TRACE("vertices");
  expect_named(tracked.vertex_keys, input.n_vertices(), named.removed_vertices,
               named.added_vertices);
}

void expect_rest_untouched(const Soup& input, const RepairResult& result) {
  ASSERT_EQ(result.meshes.size(), 1U);
  const TrackedMesh& tracked = result.meshes.front().tracked;
  const Named named = named_in(result.log);
  expect_vertices_untouched(input, result, named);
  const bool may_rename =
      has_step(result.log, DefectCode::Corrupt) || has_step(result.log, DefectCode::Numbering);
  const bool may_change_normals = has_step(result.log, DefectCode::VertexNormal);
  for (Index f = 0; f < tracked.soup.n_faces(); ++f) {
    const Index key = tracked.face_keys[f];
    if (key >= input.n_faces()) continue;
    EXPECT_EQ(group_name(tracked.soup, f), group_name(input, key));
    if (tracked.soup.format == Format::Mesh && !may_rename) {
      EXPECT_EQ(tracked.soup.face_ids.of(f), input.face_ids.of(key)) << "face " << key;
    }
    if (named.changed_faces.contains(key)) continue;
    EXPECT_EQ(corner_keys(tracked, f), input.triangles[key]) << "face " << key;
    if (!may_change_normals) expect_normals_untouched(input, tracked, f);
  }
}

/// Tells whether a point of a face lies between inside and outside. What lies within the solid, or
/// on faces that cancel each other, may go where faces intersect.
bool is_essential(const Soup& soup, const Vec3& point, const Vec3& normal, double step) {
  constexpr double kSurelyInside = 0.6;
  const double length = normal.norm();
  if (!(length > 0.0)) return false;
  const double front = test::summed_winding(soup, point + step / length * normal);
  const double behind = test::summed_winding(soup, point - step / length * normal);
  const bool is_within = std::abs(front) > kSurelyInside && std::abs(behind) > kSurelyInside;
  return !is_within && std::abs(front - behind) > 0.5;
}

/// The input but for debris of solids that was dropped, which is named, and has little area.
Soup without_dropped_debris(const Soup& input, const RepairResult& result) {
  constexpr double kLargestShare = 0.05;
  std::vector<Index> dropped;
  double area = 0.0;
  double all = 0.0;
  const auto area_of = [&](Index face) {
    const auto [a, b, c] = corners_of(input, face);
    return (b - a).cross(c - a).norm();
  };
  for (Index face = 0; face < input.n_faces(); ++face) {
    if (is_in_complex(input.triangles[face])) all += area_of(face);
  }
  for (const LoggedOperation& operation : result.log.operations) {
    if (result.log.steps[operation.step].pass != "drop fragments") continue;
    for (const Index key : operation.removed_faces) {
      if (key >= input.n_faces()) continue;
      dropped.push_back(key);
      if (is_in_complex(input.triangles[key])) area += area_of(key);
    }
  }
  EXPECT_LE(area, kLargestShare * all);
  return shapes::without_faces(input, dropped);
}

void expect_within_deviation(const Soup& input, const RepairResult& result) {
  EXPECT_LE(result.deviation, result.max_deviation);
  const Box3 box = used_box(input);
  if (box.isEmpty()) return;
  const double size = box.diagonal().norm();
  const double spacing = size / 24;
  // To the sampler, a point of a face that is all but flat is as far as that face is high.
  const double rounding = 1e-9 * size;
  const TrackedMesh& tracked = result.meshes.front().tracked;
  const bool was_cut = has_step(result.log, DefectCode::SelfIntersection);
  const double lost =
      test::sampled_distance(without_dropped_debris(input, result), tracked.soup, spacing,
                             [&](const Vec3& point, const Vec3& normal) {
                               return !was_cut || is_essential(input, point, normal, 1e-6 * size);
                             });
  const double gained = test::sampled_distance(without_patches(result), input, spacing);
  EXPECT_LE(lost, result.max_deviation + rounding);
  EXPECT_LE(gained, result.max_deviation + rounding);
  EXPECT_LE(std::max(lost, gained), result.deviation + rounding);
}

void expect_valid(const RepairResult& result) {
  for (const RepairedMesh& mesh : result.meshes) {
    const Soup& soup = mesh.tracked.soup;
    EXPECT_TRUE(validate(build(soup), soup).empty());
    EXPECT_EQ(mesh.tracked.vertex_keys.size(), soup.n_vertices());
    EXPECT_EQ(mesh.tracked.face_keys.size(), soup.n_faces());
    std::size_t n_missing = 0;
    for (const Triangle& t : soup.triangles) {
      for (const Index v : t) {
        n_missing += v == kNoIndex ? 1 : 0;
        EXPECT_TRUE(v == kNoIndex || v < soup.n_vertices());
      }
    }
    EXPECT_EQ(n_missing, soup.missing.size());
    EXPECT_TRUE(std::all_of(soup.positions.begin(), soup.positions.end(),
                            [](const Vec3& p) { return p.allFinite(); }));
  }
}

}  // namespace meshalyzer
