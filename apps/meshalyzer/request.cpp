#include "request.h"

namespace meshalyzer {
namespace {

SetQuestions questions_of(const Options& options) {
  SetQuestions questions;
  questions.statistics = options.mesh.scope == Scope::Everything && !options.mesh.goodness;
  const bool all = !options.questions.any() && questions.statistics;
  questions.intersections = all || options.questions.intersections;
  if (all || options.questions.separation) {
    questions.separation = options.separation;
  }
  questions.force = options.force;
  return questions;
}

}  // namespace

Request request_of(const Options& options, bool is_set) {
  Request request;
  request.mesh = options.mesh;
  request.list_offenders = options.offenders != OffenderStyle::None;
  request.is_set = is_set;
  request.time_limit = options.time_limit;
  if (is_set) {
    request.between = questions_of(options);
  }
  return request;
}

}  // namespace meshalyzer
