#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/picture/field.h"
#include "meshalyzer/picture/internal/worst_defects.h"
#include "meshalyzer/picture/separation_values.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Computes fields one after the other and keeps intermediate results that several need.
class FieldComputer {
 public:
  explicit FieldComputer(const FieldSource& source) : source_(source) {}

  [[nodiscard]] std::optional<Field> compute(FieldName name) {
    switch (name) {
      case FieldName::Gaussian:
        return of_vertices(name, FieldKind::Signed, curvature().gaussian);
      case FieldName::Mean:
        return of_vertices(name, FieldKind::Signed, curvature().mean);
      case FieldName::K1:
        return of_vertices(name, FieldKind::Signed, curvature().k1);
      case FieldName::K2:
        return of_vertices(name, FieldKind::Signed, curvature().k2);
      case FieldName::Valence:
        return of_vertices(name, FieldKind::Magnitude, valences());
      case FieldName::AspectRatio:
        return of_faces(name, FieldKind::Magnitude, by_record(face_measures().aspect_ratio));
      case FieldName::Area:
        return of_faces(name, FieldKind::Magnitude, by_record(face_measures().area));
      case FieldName::Component:
        return of_faces(name, FieldKind::Category, by_record(source_.mesh.components().of_face));
      case FieldName::Defect:
        return defects();
      case FieldName::Separation:
        return separation();
      case FieldName::Deviation:
        return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  static Field of_vertices(FieldName name, FieldKind kind, std::vector<double> values) {
    return {name, FieldPlace::Vertices, kind, std::move(values)};
  }
  static Field of_faces(FieldName name, FieldKind kind, std::vector<double> values) {
    return {name, FieldPlace::Faces, kind, std::move(values)};
  }

  const Curvature& curvature() {
    if (!curvature_) {
      curvature_ = measure_curvature(source_.mesh.cut(), source_.area);
    }
    return *curvature_;
  }

  const FaceMeasures& face_measures() {
    if (!face_measures_) {
      face_measures_ = measure_faces(source_.mesh.cut().mesh);
    }
    return *face_measures_;
  }

  [[nodiscard]] std::vector<double> valences() const {
    const std::vector<Index> valences = vertex_valences(source_.mesh.cut());
    std::vector<double> values(valences.size());
    std::transform(valences.begin(), valences.end(), values.begin(),
                   [](Index valence) { return valence == 0 ? kNaN : valence; });
    return values;
  }

  [[nodiscard]] std::optional<Field> defects() {
    if (source_.defects == nullptr) {
      return std::nullopt;
    }
    return of_faces(
        FieldName::Defect, FieldKind::Category,
        spread_over_components(worst_defects(source_.mesh.soup(), *source_.defects),
                               *source_.defects, source_.mesh.cut(), source_.mesh.components()));
  }

  [[nodiscard]] std::optional<Field> separation() const {
    if (source_.separation == nullptr) {
      return std::nullopt;
    }
    std::vector<double> values = separation_values(source_.mesh.soup(), *source_.separation);
    const bool is_inside =
        std::any_of(values.begin(), values.end(), [](double distance) { return distance < 0.0; });
    return of_vertices(FieldName::Separation, is_inside ? FieldKind::Signed : FieldKind::Magnitude,
                       std::move(values));
  }

  /// Returns the values of mesh faces in the order of the file's faces.
  template <typename T>
  [[nodiscard]] std::vector<double> by_record(const std::vector<T>& of_mesh_faces) const {
    const std::vector<Index>& faces = source_.mesh.cut().side.faces;
    std::vector<double> values(source_.mesh.soup().n_faces(), kNaN);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      values[faces[i]] = static_cast<double>(of_mesh_faces[i]);
    }
    return values;
  }

  const FieldSource& source_;
  std::optional<Curvature> curvature_;
  std::optional<FaceMeasures> face_measures_;
};

/// Combines the values of two faces round a vertex; more are combined one after the other.
double combined(FieldName name, double a, double b) {
  switch (name) {
    case FieldName::Area:
      return a + b;
    case FieldName::Defect:
      return worse_defect(a, b);
    default:
      return std::max(a, b);
  }
}

}  // namespace

std::vector<Field> compute_fields(const FieldSource& source, const std::vector<FieldName>& names) {
  require_finite_positions(source.mesh.cut().mesh);
  FieldComputer computer(source);
  std::vector<Field> fields;
  for (const FieldName name : names) {
    if (std::optional<Field> field = computer.compute(name)) {
      fields.push_back(std::move(*field));
    }
  }
  return fields;
}

std::vector<double> at_vertices(const Field& field, const Soup& soup) {
  if (field.place == FieldPlace::Vertices) {
    return field.values;
  }
  std::vector<double> values(soup.n_vertices(), kNaN);
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    const double value = field.name == FieldName::Area ? field.values[f] / 3.0 : field.values[f];
    if (std::isnan(value)) {
      continue;
    }
    for (const Index v : soup.triangles[f]) {
      if (v != kNoIndex) {
        values[v] = std::isnan(values[v]) ? value : combined(field.name, values[v], value);
      }
    }
  }
  return values;
}

}  // namespace meshalyzer
