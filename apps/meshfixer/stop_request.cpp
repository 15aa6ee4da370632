#include "stop_request.h"

namespace meshalyzer::fixer {

bool StopRequest::is_made() const {
  return InterruptGuard::is_interrupted() || deadline_.is_over();
}

std::string StopRequest::note() {
  return InterruptGuard::is_interrupted()
             ? "the repair was interrupted: more might have been repaired"
             : "the repair ended at its time limit: more might have been repaired";
}

}  // namespace meshalyzer::fixer
