#include "meshalyzer/analysis/goodness.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"

namespace meshalyzer {
namespace {

class Reasons {
 public:
  void add(std::string reason) { reasons_.push_back(std::move(reason)); }

  /// Adds a reason unless the attribute is yes.
  void require(const Answer& answer, const std::string& name) {
    if (!answer.value) {
      add(name + " is undefined: " + answer.reason);
    } else if (!*answer.value) {
      add("not " + name);
    }
  }

  /// Adds a reason unless the count is zero.
  void forbid(std::size_t count, const std::string& what) {
    if (count != 0) {
      add(what + ": " + grouped(count));
    }
  }

  [[nodiscard]] std::vector<std::string> take() { return std::move(reasons_); }

 private:
  std::vector<std::string> reasons_;
};

void judge_measures(const Characteristics& c, const GoodnessThresholds& thresholds,
                    Reasons& reasons) {
  reasons.forbid(c.aspect_ratio.infinite, "faces of infinite aspect ratio");
  if (c.aspect_ratio.count != 0 && !(c.aspect_ratio.max < thresholds.aspect_ratio)) {
    reasons.add("largest aspect ratio " + shortest(c.aspect_ratio.max) + " is not below " +
                shortest(thresholds.aspect_ratio));
  }
  if (c.edge_angle.count != 0 && !(c.edge_angle.min > thresholds.edge_angle_degrees)) {
    reasons.add("smallest edge angle " + shortest(c.edge_angle.min) + " is not above " +
                shortest(thresholds.edge_angle_degrees));
  }
  if (c.edge_length.count != 0 && !(c.edge_length.min > thresholds.edge_length)) {
    reasons.add("shortest edge " + shortest(c.edge_length.min) + " is not longer than " +
                shortest(thresholds.edge_length));
  }
}

void forbid_pairs(const Characteristics& c, Reasons& reasons) {
  const std::string pairs = "intersecting pairs of faces";
  if (c.is_search_stopped) {
    reasons.add(pairs + ": at least " + grouped(c.intersecting_pairs) +
                ", the search ended at its time limit");
  } else {
    reasons.forbid(c.intersecting_pairs, pairs);
  }
}

void require_fitness(const Analysis& analysis, Reasons& reasons) {
  reasons.require(analysis.attributes.closed, "closed");
  reasons.require(analysis.attributes.manifold, "manifold");
  reasons.require(analysis.attributes.outward, "outward");
  forbid_pairs(analysis.characteristics, reasons);
  reasons.forbid(analysis.integrity.orphan_vertices, "orphan vertices");
  reasons.forbid(analysis.integrity.missing_vertices, "missing vertices");
  reasons.forbid(analysis.integrity.degenerate_faces, "degenerate faces");
  reasons.forbid(analysis.integrity.torn_lines, "torn lines");
  if (!analysis.integrity.contiguous_vertices) {
    reasons.add("vertex numbering is not contiguous");
  }
  if (!analysis.integrity.contiguous_faces) {
    reasons.add("face numbering is not contiguous");
  }
}

Goodness verdict(Reasons reasons) {
  Goodness goodness;
  goodness.reasons = reasons.take();
  goodness.good = goodness.reasons.empty();
  return goodness;
}

}  // namespace

Goodness judge_fitness(const Analysis& analysis) {
  Reasons reasons;
  require_fitness(analysis, reasons);
  return verdict(std::move(reasons));
}

Goodness judge(const Analysis& analysis, const GoodnessThresholds& thresholds) {
  Reasons reasons;
  require_fitness(analysis, reasons);
  judge_measures(analysis.characteristics, thresholds, reasons);
  return verdict(std::move(reasons));
}

const std::optional<Goodness>& verdict_of(const Analysis& analysis) {
  return analysis.goodness ? analysis.goodness : analysis.fitness;
}

std::string verdict_text(const Goodness& verdict) {
  if (verdict.good) return "good";
  std::string text = "NOT good";
  for (const std::string& reason : verdict.reasons) {
    text.append(&reason == &verdict.reasons.front() ? ": " : "; ").append(reason);
  }
  return text;
}

}  // namespace meshalyzer
