#include "outputs.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/file_replacement.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/set_report.h"
#include "meshalyzer/report/text/summary_table.h"
#include "pictures.h"
#include "terminal.h"

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>

namespace meshalyzer {
namespace {

/// Writes the JSON report to standard output or to a file, which is replaced when the report is
/// complete.
class JsonOutput : public Output {
 public:
  /// @throws IoError if the file cannot be written.
  JsonOutput(const Run& run, std::ostream& out);

  JsonOutput(const JsonOutput&) = delete;
  JsonOutput& operator=(const JsonOutput&) = delete;

  // The following functions throw IoError if the file cannot be written.

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void on_findings(const ObjectFindings& findings) override;
  void finish(const SetAnalysis* set) override;

 private:
  const Run& run_;
  std::optional<FileReplacement> file_;
  JsonReport report_;
};

std::optional<FileReplacement> open(const ReportTarget& target) {
  return target.is_stdout() ? std::nullopt : std::optional<FileReplacement>(target.file);
}

JsonOutput::JsonOutput(const Run& run, std::ostream& out)
    : run_(run),
      file_(open(*run.options.json)),
      report_(
          [this, &out](std::string_view text) {
            if (file_) {
              file_->write(text);
            } else {
              out << text;
            }
          },
          run.request.list_offenders ? JsonOffenders::List : JsonOffenders::Omit) {}

void JsonOutput::on_mesh(Index, const Analysis& mesh) {
  report_.add(mesh);
}

void JsonOutput::on_unreadable(Index number, const std::string& why) {
  report_.add_unreadable(run_.inputs.files[number], why);
}

void JsonOutput::on_findings(const ObjectFindings& findings) {
  report_.add(findings, run_.inputs.names);
}

void JsonOutput::finish(const SetAnalysis* set) {
  report_.finish(set);
  if (file_) {
    file_->commit();
  }
}

/// Writes the part of a report about the set as a whole, which follows the meshes. A set without
/// meshes has no such part.
void write_set(const SetAnalysis* set, const Run& run, std::ostream& out) {
  if (set == nullptr || set->meshes == 0) {
    return;
  }
  const OffenderStyle offenders = run.options.offenders;
  const std::string text = run.request.between.statistics ? text_report(*set, offenders)
                                                          : text_report_between(*set, offenders);
  out << (text.empty() ? "" : "\n") << text;
}

/// Writes the report as text: each mesh when it is done, and the findings about a set.
class TextOutput : public Output {
 public:
  TextOutput(const Run& run, std::ostream& out) : run_(run), out_(out) {}

  void on_mesh(Index number, const Analysis& mesh) override;
  void finish(const SetAnalysis* set) override;

 private:
  const Run& run_;
  std::ostream& out_;
  std::size_t n_written_ = 0;
};

void TextOutput::on_mesh(Index, const Analysis& mesh) {
  const bool is_among_others = run_.inputs.is_set || run_.inputs.files.size() > 1;
  const std::string name = without_controls(mesh.path);
  const bool is_verdict = mesh.goodness && run_.options.offenders == OffenderStyle::None;
  if (is_among_others && is_verdict) {
    out_ << name << ": ";
  } else if (is_among_others) {
    out_ << (n_written_ == 0 ? "" : "\n") << "==== " << name << " ====\n";
  }
  out_ << text_report(mesh, run_.options.offenders);
  ++n_written_;
}

void TextOutput::finish(const SetAnalysis* set) {
  write_set(set, run_, out_);
}

/// Writes a table with one line for each mesh (--summary), and the findings about a set.
class SummaryOutput : public Output {
 public:
  SummaryOutput(const Run& run, std::ostream& out);

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void finish(const SetAnalysis* set) override;

 private:
  const Run& run_;
  std::ostream& out_;
  /// The width of the first column.
  std::size_t name_width_;
};

SummaryOutput::SummaryOutput(const Run& run, std::ostream& out)
    : run_(run),
      out_(out),
      name_width_(summary_width(run.inputs.names,
                                is_terminal(out) ? NameLength::Fitted : NameLength::Whole)) {
  out_ << summary_header(name_width_);
}

void SummaryOutput::on_mesh(Index number, const Analysis& mesh) {
  out_ << summary_line(run_.inputs.names[number], mesh, name_width_);
}

void SummaryOutput::on_unreadable(Index number, const std::string& why) {
  out_ << summary_of_unreadable(run_.inputs.names[number], why, name_width_);
}

void SummaryOutput::finish(const SetAnalysis* set) {
  write_set(set, run_, out_);
}

/// Prints only the total volume of a set (-v).
class VolumeOutput : public Output {
 public:
  explicit VolumeOutput(Streams streams) : streams_(streams) {}

  void finish(const SetAnalysis* set) override {
    if (set == nullptr || set->meshes == 0) {
      return;
    }
    if (!set->volume.reason.empty()) {
      streams_.err << "meshalyzer: total volume: " << set->volume.reason << '\n';
    }
    streams_.out << (set->volume.value ? shortest(*set->volume.value) : "undefined") << '\n';
  }

 private:
  Streams streams_;
};

/// Returns the output for a person on standard output, or null if something else goes there.
std::unique_ptr<Output> output_for_person(const Run& run, Streams streams) {
  if (is_stdout(run.options.json) || is_stdout(run.options.ndjson)) {
    return nullptr;
  }
  if (run.options.total_volume) {
    return std::make_unique<VolumeOutput>(streams);
  }
  if (run.options.summary) {
    return std::make_unique<SummaryOutput>(run, streams.out);
  }
  return std::make_unique<TextOutput>(run, streams.out);
}

}  // namespace

std::vector<std::unique_ptr<Output>> outputs_of(const Run& run, Streams streams) {
  std::vector<std::unique_ptr<Output>> outputs;
  if (run.options.json) {
    outputs.push_back(std::make_unique<JsonOutput>(run, streams.out));
  }
  if (draws_pictures(run.options)) {
    outputs.push_back(std::make_unique<Pictures>(run));
  }
  if (std::unique_ptr<Output> for_person = output_for_person(run, streams)) {
    outputs.push_back(std::move(for_person));
  }
  return outputs;
}

}  // namespace meshalyzer
