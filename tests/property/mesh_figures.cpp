#include "mesh_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

template <typename T>
std::int64_t number(const std::optional<T>& maybe) {
  return maybe ? static_cast<std::int64_t>(*maybe) : -1;
}

std::int64_t number(std::size_t n) {
  return static_cast<std::int64_t>(n);
}

void add_attributes(const Attributes& a, MeshFigures& figures) {
  figures.counts["closed"] = number(a.closed.value);
  figures.counts["manifold"] = number(a.manifold.value);
  figures.counts["orientable"] = number(a.orientable.value);
  figures.counts["consistent"] = number(a.consistent.value);
  figures.counts["outward"] = number(a.outward.value);
}

void add_integrity(const Integrity& integrity, MeshFigures& figures) {
  figures.counts["orphan vertices"] = number(integrity.orphan_vertices);
  figures.counts["missing vertices"] = number(integrity.missing_vertices);
  figures.counts["degenerate faces"] = number(integrity.degenerate_faces);
  figures.counts["duplicate vertex ids"] = number(integrity.duplicate_vertex_indices);
  figures.counts["duplicate face ids"] = number(integrity.duplicate_face_indices);
}

void add_counts(const Characteristics& c, MeshFigures& figures) {
  figures.counts["vertices"] = number(c.vertices);
  figures.counts["faces"] = number(c.faces);
  figures.counts["edges"] = number(c.edges);
  figures.counts["components"] = number(c.components);
  figures.counts["edge components"] = number(c.edge_components);
  figures.counts["boundaries"] = number(c.boundaries);
  figures.counts["border edges"] = number(c.border_edges);
  figures.counts["non-manifold edges"] = number(c.non_manifold_edges);
  figures.counts["non-manifold vertices"] = number(c.non_manifold_vertices);
  figures.counts["pinched vertices"] = number(c.pinched_vertices);
  figures.counts["indistinguishable vertices"] = number(c.indistinguishable_vertices);
  figures.counts["indistinguishable edges"] = number(c.indistinguishable_edges);
  figures.counts["flipped edges"] = number(c.flipped_edges);
  figures.counts["zero-area faces"] = number(c.zero_area_faces);
  figures.counts["duplicate faces"] = number(c.duplicate_faces);
  figures.counts["intersecting faces"] = number(c.intersecting_faces);
  figures.counts["unwelded pairs"] = number(c.unwelded_pairs);
  figures.counts["genus"] = number(c.genus.value);
  figures.counts["genus of components"] = number(c.genus_of_components);
}

void add_component(const Analysis& analysis, const ComponentAnalysis& c, MeshFigures& figures) {
  figures.components.insert(
      {number(c.faces), number(c.vertices), number(c.edges), number(c.edge_components),
       number(c.boundaries), number(c.border_edges), number(c.non_manifold_edges),
       number(c.non_manifold_vertices), number(c.flipped_edges), number(c.zero_area_faces),
       number(c.intersecting_pairs), c.closed ? 1 : 0, c.manifold ? 1 : 0, number(c.orientable),
       number(c.consistent), number(c.outward), number(c.genus),
       c.inside ? number(analysis.components[*c.inside].faces) : -1});
}

/// @param span  The largest value that rounding is relative to; 0 where it is each value itself.
void add_summary(const std::string& name, const Summary& s, int dimension, double span,
                 MeshFigures& figures) {
  figures.counts[name + " count"] = number(s.count);
  figures.counts[name + " infinite"] = number(s.infinite);
  for (const auto& [figure, value] :
       {std::pair("min", s.min), std::pair("max", s.max), std::pair("median", s.median),
        std::pair("mean", s.mean), std::pair("total", s.total)}) {
    figures.reals[name + ' ' + figure] = {value, std::max(std::abs(value), span), dimension};
  }
}

}  // namespace

MeshFigures figures_of(const Analysis& analysis) {
  MeshFigures figures;
  const Characteristics& c = analysis.characteristics;
  add_attributes(analysis.attributes, figures);
  add_integrity(analysis.integrity, figures);
  add_counts(c, figures);
  for (const IntersectingPair& pair : analysis.offenders.intersecting_pairs) {
    ++figures.counts["pairs: " + std::string(contact_name(pair.kind))];
  }
  for (const ComponentAnalysis& each : analysis.components) add_component(analysis, each, figures);
  add_summary("face area", c.face_area, 2, 0, figures);
  add_summary("aspect ratio", c.aspect_ratio, 0, 0, figures);
  add_summary("corner angle", c.corner_angle, 0, 60, figures);
  add_summary("edge length", c.edge_length, 1, 0, figures);
  add_summary("edge angle", c.edge_angle, 0, 360, figures);
  add_summary("valence", c.vertex_valence, 0, 0, figures);
  const double diagonal = c.bounding_box.isEmpty() ? 0.0 : c.bounding_box.diagonal().norm();
  figures.reals["area"] = {c.area, c.area, 2};
  figures.reals["diagonal"] = {diagonal, diagonal, 1};
  figures.counts["has volume"] = c.volume.value ? 1 : 0;
  figures.reals["volume"] = {c.volume.value.value_or(0), c.area * diagonal, 3};
  return figures;
}

void expect_same_figures(const MeshFigures& expected, const MeshFigures& actual,
                         const FigureTolerance& tolerance) {
  for (const auto& [name, count] : expected.counts) {
    const auto found = actual.counts.find(name);
    EXPECT_EQ(found == actual.counts.end() ? 0 : found->second, count) << name;
  }
  EXPECT_EQ(actual.counts.size(), expected.counts.size()) << "other kinds of pairs";
  EXPECT_EQ(actual.components, expected.components);
  for (const auto& [name, figure] : expected.reals) {
    const double factor = std::pow(tolerance.scale, figure.dimension);
    EXPECT_NEAR(actual.reals.at(name).value, factor * figure.value,
                tolerance.relative * factor * figure.magnitude)
        << name;
  }
}

}  // namespace meshalyzer
