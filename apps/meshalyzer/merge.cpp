#include "merge.h"

#include "interrupt.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/report/journal/known_lines.h"
#include "meshalyzer/report/journal/parts.h"
#include "run.h"

namespace meshalyzer {
namespace {

/// Returns the options for the report of the journals: those of this call, and the offenders that
/// the journals list.
Options told_as(Options options, const Request& request) {
  options.offenders = request.list_offenders ? OffenderStyle::Ids : OffenderStyle::None;
  return options;
}

}  // namespace

ExitCode merge(const Options& how, Streams streams) {
  const JournalSubject subject = read_subject(how.paths);
  const Options options = told_as(how, subject.request);
  // The statistics of a set are computed again from the files, which therefore must not have
  // changed.
  if (subject.request.is_set && subject.request.between.statistics) {
    require_unchanged(subject.files);
  }
  KnownLines known(subject, KnownLines::Missing::Refuse);
  for (const std::string& journal : how.paths) {
    known.add(journal);
  }
  const ThreadLimit limit(options.threads);
  const UnpackLimit unpack_limit(options.max_unpack_ratio);
  const InterruptGuard guard;
  const Inputs inputs{subject.files.paths, subject.files.names, subject.request.is_set, {}};
  const PicturePaths no_pictures;
  return carry_out({options, inputs, subject.request, no_pictures, &known}, streams);
}

}  // namespace meshalyzer
