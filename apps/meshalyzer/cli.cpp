#include "cli.h"

#include "inputs.h"
#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/report/json.h"
#include "meshalyzer/report/text.h"
#include "options.h"
#include "progress_line.h"

#include <exception>
#include <new>
#include <ostream>
#include <utility>

namespace meshalyzer {
namespace {

/// One call of the program: reads, analyses, tells.
class Session {
 public:
  Session(const Options& options, Inputs inputs, std::ostream& out, std::ostream& err);

  [[nodiscard]] ExitCode work();

 private:
  void analyze_file(std::size_t i);
  void tell(const Analysis& analysis);
  void keep(Analysis analysis);
  void tell_set(const SetAnalysis& set);
  void write_json(const SetAnalysis& set);
  void complain(std::string_view message);
  /// Whether the text report goes to standard output.
  [[nodiscard]] bool tells_text() const;

  const Options& options_;
  Inputs inputs_;
  std::ostream& out_;
  std::ostream& err_;
  ProgressLine progress_;
  std::vector<Analysis> analyses_;
  std::size_t n_told_ = 0;
  std::size_t n_unreadable_ = 0;
  bool all_good_ = true;
  bool trouble_ = false;
};

ProgressLine::State progress_state(const Options& options, const std::ostream& err) {
  return options.progress == Options::Progress::Never ? ProgressLine::State::Off
                                                      : terminal_state(err);
}

Session::Session(const Options& options, Inputs inputs, std::ostream& out, std::ostream& err)
    : options_(options),
      inputs_(std::move(inputs)),
      out_(out),
      err_(err),
      progress_(err, progress_state(options, err)) {}

ExitCode Session::work() {
  for (const std::string& trouble : inputs_.troubles) {
    complain(trouble);
  }
  for (std::size_t i = 0; i < inputs_.files.size() && out_; ++i) {
    analyze_file(i);
  }
  progress_.clear();
  const SetAnalysis set = analyze_set(analyses_, n_unreadable_);
  if (inputs_.is_set && !analyses_.empty()) {
    tell_set(set);
  }
  if (options_.json) {
    write_json(set);
  }
  if (!out_.flush()) {
    complain("meshalyzer: standard output: cannot be written");
  }
  return trouble_ ? ExitCode::Trouble : all_good_ ? ExitCode::Done : ExitCode::NotGood;
}

void Session::analyze_file(std::size_t i) {
  const std::string& file = inputs_.files[i];
  std::string label = "[";
  label += std::to_string(i + 1) + "/" + std::to_string(inputs_.files.size()) + "] " + file;
  progress_.show(label);
  AnalysisOptions options = options_.analysis;
  options.on_phase = [&](std::string_view phase) {
    progress_.show(label + ": " + std::string(phase));
  };
  try {
    Analysis analysis = analyze(read_mesh(file), file, options);
    progress_.clear();
    if (tells_text()) {
      tell(analysis);
    }
    keep(std::move(analysis));
  } catch (const IoError& error) {
    ++n_unreadable_;
    complain(error.what());
  } catch (const std::bad_alloc&) {
    ++n_unreadable_;
    complain(file + ": not enough memory");
  }
}

bool Session::tells_text() const {
  return options_.show == Show::Report && !(options_.json && options_.json->is_stdout());
}

void Session::tell(const Analysis& analysis) {
  const bool among_others = inputs_.is_set || inputs_.files.size() > 1;
  const bool only_verdict = analysis.goodness && options_.offenders == OffenderStyle::None;
  if (among_others && only_verdict) {
    out_ << analysis.path << ": ";
  } else if (among_others) {
    out_ << (n_told_ == 0 ? "" : "\n") << "==== " << analysis.path << " ====\n";
  }
  out_ << text_report(analysis, options_.offenders);
  ++n_told_;
}

/// Where JSON is to follow everything is kept, else only what the totals need: a folder may hold
/// many meshes.
void Session::keep(Analysis analysis) {
  all_good_ = all_good_ && (!analysis.goodness || analysis.goodness->good);
  if (!options_.json) {
    analysis.vertex_ids = {};
    analysis.face_ids = {};
    analysis.components = {};
    analysis.component_statistics = {};
    analysis.offenders = {};
  }
  analysis.positions = {};
  analysis.triangles = {};
  analyses_.push_back(std::move(analysis));
}

/// What there is to say of a folder. With -a and -g that is nothing.
void Session::tell_set(const SetAnalysis& set) {
  if (options_.show == Show::TotalVolume) {
    if (!set.volume.reason.empty()) {
      err_ << "meshalyzer: total volume: " << set.volume.reason << '\n';
    }
    out_ << (set.volume.value ? shortest(*set.volume.value) : "undefined") << '\n';
    return;
  }
  const bool has_totals =
      options_.analysis.scope == Scope::Everything && !options_.analysis.goodness;
  if (tells_text() && has_totals) {
    out_ << '\n' << text_report(set);
  }
}

void Session::write_json(const SetAnalysis& set) {
  const JsonOffenders offenders =
      options_.offenders == OffenderStyle::None ? JsonOffenders::Omit : JsonOffenders::List;
  const std::string text = json_report(analyses_, inputs_.is_set ? &set : nullptr, offenders);
  if (options_.json->is_stdout()) {
    out_ << text;
    return;
  }
  try {
    replace_file(options_.json->file, text);
  } catch (const IoError& error) {
    complain(error.what());
  }
}

void Session::complain(std::string_view message) {
  progress_.clear();
  err_ << message << '\n';
  trouble_ = true;
}

/// What speaks against this use of folders, which only looking at the paths can tell.
void check_folders(const Options& options) {
  if (options.show != Show::TotalVolume) {
    return;
  }
  for (const std::string& path : options.paths) {
    if (!is_folder(path)) {
      throw UsageError("-v needs a folder, and " + path + " is none");
    }
  }
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  try {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.answer) {
      out << *command.answer << std::flush;
      return static_cast<int>(out ? ExitCode::Done : ExitCode::Trouble);
    }
    check_folders(command.options);
    const ThreadLimit limit(command.options.threads);
    Session session(command.options, find_inputs(command.options.paths), out, err);
    return static_cast<int>(session.work());
  } catch (const UsageError& error) {
    err << "meshalyzer: " << error.what() << "\nTry 'meshalyzer --help'.\n";
    return static_cast<int>(ExitCode::Usage);
  } catch (const std::exception& error) {
    err << "meshalyzer: " << error.what() << '\n';
    return static_cast<int>(ExitCode::Trouble);
  }
}

}  // namespace meshalyzer
