#include "meshalyzer/io/rewrite/face_plan.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

using Relation = ElementOrigin::Relation;

/// Returns the element that each record of the source is; kNoIndex if it was dropped.
std::vector<Index> new_numbers(const std::vector<ElementOrigin>& origins, std::size_t n_records) {
  std::vector<Index> numbers(n_records, kNoIndex);
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (origins[i].relation == Relation::Same) {
      numbers[origins[i].record] = static_cast<Index>(i);
    }
  }
  return numbers;
}

class FacePlanner {
 public:
  FacePlanner(const EditedMesh& mesh, const FaceRecords& records)
      : mesh_(mesh), records_(records), faces_(new_faces(mesh)) {}

  FacePlan plan() {
    plan_.changes.reserve(records_.size());
    for (Index r = 0; r < records_.size(); ++r) {
      plan_.changes.push_back(change_of(r));
      if (plan_.changes.back() == RecordChange::Dropped) {
        place_triangles(r);
      }
    }
    place_added();
    std::stable_sort(placed_.begin(), placed_.end(), [](const Placed& a, const Placed& b) {
      return std::tie(a.record, a.rank, a.face) < std::tie(b.record, b.rank, b.face);
    });
    number_faces();
    plan_.n_split_polygons = count_split_polygons();
    plan_.faces = std::move(faces_);
    return std::move(plan_);
  }

 private:
  /// The ranks at one record: its own triangles, faces made from them, patches beside them.
  enum class Rank : std::uint8_t { Own, MadeOf, Beside };
  struct Placed {
    Index record;
    Rank rank;
    Index face;
  };

  [[nodiscard]] RecordChange change_of(Index record) const {
    const Index begin = records_.first_triangle[record];
    const Index end = records_.first_triangle[record + 1];
    if (std::find(faces_.begin() + begin, faces_.begin() + end, kNoIndex) != faces_.begin() + end) {
      return RecordChange::Dropped;
    }
    if (is_fan(begin, end)) {
      return RecordChange::Kept;
    }
    for (Index t = begin; t < end; ++t) {
      if (!is_turn_of(source_corners(faces_[t]), mesh_.source.triangles[t])) {
        return RecordChange::Dropped;
      }
    }
    return RecordChange::Turned;
  }

  /// Tells whether some triangles are still a fan round one corner, each beginning where the
  /// previous one ends.
  [[nodiscard]] bool is_fan(Index begin, Index end) const {
    const Triangle& first = mesh_.source.triangles[begin];
    if (first[1] == first[2] && source_corners(faces_[begin]) != first) {
      return false;  // the record has fewer than three corners
    }
    const Index apex = mesh_.soup.triangles[faces_[begin]][0];
    Index last = mesh_.soup.triangles[faces_[begin]][1];
    for (Index t = begin; t < end; ++t) {
      const Triangle& now = mesh_.soup.triangles[faces_[t]];
      if (now[0] != apex || now[1] != last) {
        return false;
      }
      last = now[2];
    }
    return true;
  }

  /// Returns the vertices of the source that a face names; kNoIndex for others.
  [[nodiscard]] Triangle source_corners(Index face) const {
    Triangle corners = mesh_.soup.triangles[face];
    for (Index& corner : corners) {
      const bool is_old = corner != kNoIndex && mesh_.vertices[corner].relation == Relation::Same;
      corner = is_old ? mesh_.vertices[corner].record : kNoIndex;
    }
    return corners;
  }

  static bool is_turn_of(const Triangle& now, const Triangle& before) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (now[0] == before[k] && now[1] == before[(k + 2) % 3] && now[2] == before[(k + 1) % 3]) {
        return true;
      }
    }
    return false;
  }

  void place_triangles(Index record) {
    for (Index t = records_.first_triangle[record]; t < records_.first_triangle[record + 1]; ++t) {
      if (faces_[t] != kNoIndex) {
        placed_.push_back({record, Rank::Own, faces_[t]});
      }
    }
  }

  void place_added() {
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const ElementOrigin& origin = mesh_.faces[f];
      const auto face = static_cast<Index>(f);
      if (origin.relation == Relation::Same) {
        continue;
      }
      if (records_.run_ends.empty() || origin.record == kNoIndex) {
        placed_.push_back({kNoIndex, Rank::Beside, face});
      } else if (origin.relation == Relation::MadeOf) {
        placed_.push_back({records_.record_of(origin.record), Rank::MadeOf, face});
      } else {
        placed_.push_back(
            {records_.run_ends[records_.record_of(origin.record)], Rank::Beside, face});
      }
    }
  }

  void number_faces() {
    plan_.file_faces.resize(mesh_.faces.size());
    plan_.written.reserve(placed_.size());
    auto next = placed_.begin();
    const auto number_up_to = [&](Index record) {
      for (; next != placed_.end() && next->record <= record; ++next) {
        plan_.file_faces[next->face] = n_numbered_++;
        plan_.written.push_back({next->record, next->face});
        ++plan_.n_records;
      }
    };
    for (Index r = 0; r < records_.size(); ++r) {
      if (plan_.changes[r] != RecordChange::Dropped) {
        number_record(r);
      }
      number_up_to(r);
    }
    number_up_to(kNoIndex);
  }

  /// Numbers the triangles of a record; those of a reversed polygon come in the opposite order.
  void number_record(Index record) {
    const Index begin = records_.first_triangle[record];
    const Index end = records_.first_triangle[record + 1];
    for (Index t = begin; t < end; ++t) {
      const bool is_turned = plan_.changes[record] == RecordChange::Turned;
      plan_.file_faces[faces_[t]] = n_numbered_ + (is_turned ? end - 1 - t : t - begin);
    }
    n_numbered_ += end - begin;
    ++plan_.n_records;
  }

  [[nodiscard]] std::size_t count_split_polygons() const {
    std::vector<bool> is_split(records_.size(), false);
    const auto note_remainder = [&](Index triangle) {
      const Index record = records_.record_of(triangle);
      is_split[record] =
          plan_.changes[record] == RecordChange::Dropped && records_.n_triangles(record) > 1;
    };
    for (const Placed& placed : placed_) {
      const ElementOrigin& origin = mesh_.faces[placed.face];
      if (origin.relation == Relation::Same || origin.relation == Relation::MadeOf) {
        note_remainder(origin.record);
      }
    }
    std::for_each(mesh_.left_places.begin(), mesh_.left_places.end(), note_remainder);
    return static_cast<std::size_t>(std::count(is_split.begin(), is_split.end(), true));
  }

  const EditedMesh& mesh_;
  const FaceRecords& records_;
  /// The current face of each triangle of the source.
  std::vector<Index> faces_;
  std::vector<Placed> placed_;
  Index n_numbered_ = 0;
  FacePlan plan_;
};

}  // namespace

Index FaceRecords::record_of(Index triangle) const {
  const auto after = std::upper_bound(first_triangle.begin(), first_triangle.end(), triangle);
  return static_cast<Index>(after - first_triangle.begin() - 1);
}

FanCorner fan_corner(const FaceRecords& records, Index record, std::size_t local) {
  const Index first = records.first_triangle[record];
  if (local < 3) {
    return {first, local};
  }
  return {first + static_cast<Index>(local - 2), 2};
}

std::size_t local_corner(const FaceRecords& records, Index record, FanCorner corner) {
  return corner.corner == 0 ? 0 : corner.corner + corner.triangle - records.first_triangle[record];
}

FacePlan plan_faces(const EditedMesh& mesh, const FaceRecords& records) {
  return FacePlanner(mesh, records).plan();
}

std::size_t corner_written_at(const FacePlan& plan, Index record, std::size_t place,
                              std::size_t n) {
  return plan.changes[record] == RecordChange::Turned ? (n - place) % n : place;
}

Index vertex_now(const EditedMesh& mesh, const FacePlan& plan, std::span<const Index> new_vertices,
                 Index record, const FanCorner& corner) {
  // The triangles of a polygon that was turned over have the same vertices at other corners.
  if (plan.changes[record] == RecordChange::Turned) {
    return new_vertices[mesh.source.triangles[corner.triangle][corner.corner]];
  }
  return mesh.soup.triangles[plan.faces[corner.triangle]][corner.corner];
}

bool is_renumbered(const EditedMesh& mesh, const FacePlan& plan, const FaceRecords& records,
                   Index record) {
  const Index end = records.first_triangle[record + 1];
  for (Index t = records.first_triangle[record]; t < end; ++t) {
    if (mesh.soup.triangles[plan.faces[t]] != mesh.source.triangles[t]) {
      return true;
    }
  }
  return false;
}

bool keeps_order(const FacePlan& plan) {
  return std::is_sorted(plan.file_faces.begin(), plan.file_faces.end());
}

RewrittenFile rewritten_file(ByteEdits& edits, const FacePlan& plan) {
  RewrittenFile file;
  file.bytes = edits.apply();
  if (!keeps_order(plan)) file.file_faces = plan.file_faces;
  file.lost = {{AttributeKind::Polygons, plan.n_split_polygons}};
  file.lost_records = edits.lost();
  return file;
}

std::vector<Index> new_vertices(const EditedMesh& mesh) {
  return new_numbers(mesh.vertices, mesh.source.n_vertices());
}

std::vector<Index> new_faces(const EditedMesh& mesh) {
  return new_numbers(mesh.faces, mesh.source.n_faces());
}

}  // namespace meshalyzer
