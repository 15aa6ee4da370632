#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <vector>

namespace meshalyzer {
namespace {

/// The kinds of normals that the corners at one vertex have.
struct NormalThere {
  Index normal = kNoIndex;
  bool is_only_one = true;
};

std::vector<NormalThere> normals_at_vertices(const Soup& soup) {
  std::vector<NormalThere> there(soup.n_vertices());
  for (std::size_t f = 0; f < soup.corner_normals.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = soup.triangles[f][k];
      const Index normal = soup.corner_normals[f][k];
      if (v == kNoIndex || normal == kNoIndex) continue;
      NormalThere& at = there[v];
      if (at.normal == kNoIndex) at.normal = normal;
      at.is_only_one = at.is_only_one && soup.normals[normal] == soup.normals[at.normal];
    }
  }
  return there;
}

/// Turns the normals of vertices that have one; several normals at a vertex would need one
/// operation each.
void turn_normals(const Soup& soup, Index op, PassResult& result) {
  const std::vector<NormalThere> there = normals_at_vertices(soup);
  for (Index v = 0; v < there.size(); ++v) {
    if (there[v].normal == kNoIndex) continue;
    if (there[v].is_only_one) {
      result.edits.changed_normals.push_back({op, v, -soup.normals[there[v].normal]});
    } else {
      result.refused.push_back({DefectCode::VertexNormal, v, kNoIndex,
                                "it has several normals, which stay as they are"});
    }
  }
}

}  // namespace

PassResult flip_all(const PassInput& input) {
  const Soup& soup = input.tracked.soup;
  PassResult result;
  if (soup.triangles.empty()) return result;
  const Index op = result.edits.begin_operation();
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    // Another list of the soup tells which corner is missing.
    if (std::find(t.begin(), t.end(), kNoIndex) != t.end()) continue;
    result.edits.changed_faces.push_back({op, f, {t[0], t[2], t[1]}});
  }
  turn_normals(soup, op, result);
  return result;
}

}  // namespace meshalyzer
