#include "meshalyzer/report/journal/subject.h"

namespace meshalyzer {

LineHead JournalSubject::head(LineHead::Kind kind, Index number) const {
  return {.kind = kind,
          .number = number,
          .of = files.paths.size(),
          .path = files.paths[number],
          .stamp = files.stamps[number],
          .request = request,
          .set = files.fingerprint};
}

JsonOffenders JournalSubject::offenders() const {
  return request.list_offenders ? JsonOffenders::List : JsonOffenders::Omit;
}

}  // namespace meshalyzer
