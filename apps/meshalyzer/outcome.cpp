#include "outcome.h"

#include <ostream>

namespace meshalyzer {

void Outcome::on_mesh(Index, const Analysis& mesh) {
  ++n_files_done_;
  all_good_ = all_good_ && (!mesh.goodness || mesh.goodness->good);
}

void Outcome::on_unreadable(Index, const std::string& why) {
  ++n_files_done_;
  complain(why);
}

void Outcome::complain(const std::string& message) {
  err_ << message << '\n';
  trouble_ = true;
}

ExitCode Outcome::exit_code() const {
  return trouble_ ? ExitCode::Trouble : all_good_ ? ExitCode::Done : ExitCode::NotGood;
}

}  // namespace meshalyzer
