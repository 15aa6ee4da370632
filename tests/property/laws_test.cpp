#include "mesh_figures.h"
#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/write.h"
#include "meshalyzer/report/json/report.h"
#include "soups_to_try.h"
#include "support/effort.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kSeed = 11;
/// Reals are added up in another order, and slivers are right to 1e-9.
constexpr double kRounding = 1e-8;

/// Coincidence is exact, for the tolerance does not scale.
Analysis analysis_of(const Soup& soup) {
  AnalysisOptions options;
  options.exact_coincidence = true;
  return analyze(soup, "soup", options);
}

using Change = std::function<Soup(Soup)>;

/// Expects that a change of every soup leaves its figures as they are but for size and rounding.
void expect_law(const Change& change, const FigureTolerance& tolerance) {
  test::Effort effort;
  for (const NamedSoup& each : soups_to_try()) {
    if (!effort.runs_next()) continue;
    SCOPED_TRACE(each.name);
    expect_same_figures(figures_of(analysis_of(each.soup)),
                        figures_of(analysis_of(change(each.soup))), tolerance);
    if (testing::Test::HasFailure()) return;
  }
}

void sort_missing(Soup& soup) {
  std::sort(soup.missing.begin(), soup.missing.end(),
            [](const MissingReference& a, const MissingReference& b) {
              return std::tuple(a.face, a.corner) < std::tuple(b.face, b.corner);
            });
}

/// Ids in the order of their records after a permutation.
void permute(Ids& ids, const std::vector<Index>& place) {
  const std::vector<std::int32_t> old = ids.named;
  for (std::size_t i = 0; i < old.size(); ++i) ids.named[place[i]] = old[i];
}

/// Tells whether one id has several records: then it matters which comes first.
bool names_a_vertex_twice(const Soup& soup) {
  const std::set<std::int32_t> distinct(soup.vertex_ids.named.begin(), soup.vertex_ids.named.end());
  return distinct.size() != soup.vertex_ids.named.size();
}

/// shapes::shuffled_faces() with what else a file says of its faces.
Soup shuffled(const Soup& soup) {
  Soup result = shapes::shuffled_faces(soup, kSeed);
  const std::vector<Index> place = shapes::permutation(soup.n_faces(), kSeed);
  permute(result.face_ids, place);
  for (MissingReference& m : result.missing) {
    m.face = place[m.face];
    // Corners begin place % 3 later.
    m.corner = static_cast<std::uint8_t>((m.corner + 3 - m.face % 3) % 3);
  }
  sort_missing(result);
  return result;
}

Soup renumbered(const Soup& soup) {
  if (names_a_vertex_twice(soup)) return soup;
  Soup result = shapes::renumbered_vertices(soup, kSeed);
  permute(result.vertex_ids, shapes::permutation(soup.n_vertices(), kSeed));
  return result;
}

/// Mirrored in the plane x = 0, its faces turned over so that they look the same way.
Soup mirrored(Soup soup) {
  for (Vec3& p : soup.positions) p.x() = -p.x();
  for (MissingReference& m : soup.missing) {
    m.corner = static_cast<std::uint8_t>((3 - m.corner) % 3);
  }
  sort_missing(soup);
  return shapes::flipped(std::move(soup));
}

Soup with_axes_turned(Soup soup) {
  for (Vec3& p : soup.positions) p = Vec3(p.y(), p.z(), p.x());
  return soup;
}

TEST(AnalysisLaw, RenumberingVerticesChangesNothing) {
  expect_law(renumbered, {.relative = kRounding});
}

TEST(AnalysisLaw, ShufflingFacesChangesNothing) {
  expect_law(shuffled, {.relative = kRounding});
}

TEST(AnalysisLaw, TurningTheAxesChangesNothing) {
  expect_law(with_axes_turned, {.relative = kRounding});
}

TEST(AnalysisLaw, MirroringAndTurningFacesOverChangesNothing) {
  expect_law(mirrored, {.relative = kRounding});
}

TEST(AnalysisLaw, ScalingByAPowerOfTwoScalesMeasuresToTheLastBit) {
  for (const double scale : {0x1p-9, 0x1p+20}) {
    expect_law([&](Soup soup) { return shapes::scaled(std::move(soup), scale); },
               {.scale = scale, .relative = 0.0});
  }
}

TEST(AnalysisLaw, TurningAllFacesOverNegatesVolumeAndOutward) {
  test::Effort effort;
  for (const NamedSoup& each : soups_to_try()) {
    if (!effort.runs_next()) continue;
    SCOPED_TRACE(each.name);
    const MeshFigures before = figures_of(analysis_of(each.soup));
    Soup turned = shapes::flipped(each.soup);
    for (MissingReference& m : turned.missing) {
      m.corner = static_cast<std::uint8_t>((3 - m.corner) % 3);
    }
    sort_missing(turned);
    const Analysis analysis = analysis_of(turned);
    const RealFigure& volume = before.reals.at("volume");
    EXPECT_NEAR(analysis.characteristics.volume.value.value_or(0), -volume.value,
                kRounding * volume.magnitude);
    // Every one of several components points the wrong way only where all pointed the right way.
    if (analysis.components.size() == 1 && analysis.attributes.outward.value) {
      EXPECT_NE(static_cast<int>(*analysis.attributes.outward.value), before.counts.at("outward"));
    }
  }
}

/// A flavour of file to write, and the name that makes it read as such.
struct Flavour {
  std::string name;
  Format format = Format::Mesh;
  Encoding encoding = Encoding::Text;
};

const std::vector<Flavour>& flavours() {
  static const std::vector<Flavour> all{
      {"soup.mesh", Format::Mesh, Encoding::Text}, {"inria.mesh", Format::Inria, Encoding::Text},
      {"soup.obj", Format::Obj, Encoding::Text},   {"soup.off", Format::Off, Encoding::Text},
      {"text.ply", Format::Ply, Encoding::Text},   {"binary.ply", Format::Ply, Encoding::Binary}};
  return all;
}

/// Tells whether a format can hold all of a soup: none a corner without a vertex, only the native
/// one a second record of a vertex, and STL nothing but faces.
bool can_hold(Format format, const Soup& soup) {
  return soup.missing.empty() && (format == Format::Mesh || !names_a_vertex_twice(soup)) &&
         (format != Format::Stl || soup.n_faces() != 0);
}

Soup written_and_read(const Soup& soup, const Flavour& flavour) {
  return parse_mesh(print_mesh(soup, flavour.format, flavour.encoding), flavour.name);
}

std::string json_of(const Soup& soup) {
  const std::vector<Analysis> meshes{analysis_of(soup)};
  return json_report(meshes, nullptr, JsonOffenders::List);
}

TEST(AnalysisLaw, WritingAndReadingInAnyFormatChangesNothing) {
  test::Effort effort;
  for (const NamedSoup& each : soups_to_try()) {
    for (const Flavour& flavour : flavours()) {
      if (!can_hold(flavour.format, each.soup) || !effort.runs_next()) continue;
      SCOPED_TRACE(each.name + " as " + flavour.name);
      MeshFigures before = figures_of(analysis_of(each.soup));
      if (flavour.format != Format::Mesh) {
        // Only the native format names its ids.
        before.counts["duplicate face ids"] = 0;
      }
      expect_same_figures(before, figures_of(analysis_of(written_and_read(each.soup, flavour))),
                          {});
    }
  }
}

TEST(AnalysisLaw, ReportOfAFileReadBackIsTheSameByteForByte) {
  std::vector<Flavour> all = flavours();
  all.push_back({"text.stl", Format::Stl, Encoding::Text});
  all.push_back({"binary.stl", Format::Stl, Encoding::Binary});
  test::Effort effort;
  for (const NamedSoup& each : soups_to_try()) {
    for (const Flavour& flavour : all) {
      if (!can_hold(flavour.format, each.soup) || !effort.runs_next()) continue;
      SCOPED_TRACE(each.name + " as " + flavour.name);
      // Written once, so that it is a file of that format; STL forgets orphans and numbers.
      const Soup first = written_and_read(each.soup, flavour);
      EXPECT_TRUE(json_of(first) == json_of(written_and_read(first, flavour)));
    }
  }
}

}  // namespace
}  // namespace meshalyzer
