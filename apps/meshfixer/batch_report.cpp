#include "batch_report.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/repair_report.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/report/text/repair_lines.h"
#include "meshalyzer/report/text/repair_report.h"

#include <ostream>
#include <string_view>

namespace meshalyzer::fixer {
namespace {

/// Returns a JSON text on one line: line ends and indentation are never part of a value.
std::string on_one_line(std::string_view json) {
  std::string line;
  for (std::size_t at = 0; at < json.size();) {
    const std::size_t end = std::min(json.find('\n', at), json.size());
    line += json.substr(at, end - at);
    at = std::min(json.find_first_not_of(" \n", end), json.size());
  }
  return line;
}

std::string error_json(const std::string& path, const std::string& what) {
  JsonWriter json;
  json.begin_object();
  write_bytes(json, "path", path);
  write_bytes(json, "error", what);
  json.end_object();
  return json.take();
}

std::size_t n_before(const RepairReport& report) {
  return report.result.before.count(report.fixes);
}

std::string file_line(const std::string& path, const RepairReport& report) {
  std::string line = path + ": " + arrow(n_before(report), n_remaining(report)) + " defects";
  if (report.result.log.steps.empty()) line += ", unchanged";
  for (const FinalMesh& mesh : report.meshes) {
    if (!mesh.name.path.empty() && mesh.name.path != path) line += ", written: " + mesh.name.path;
  }
  if (!report.lost.empty()) line += ", lost: " + lost_text(report.lost);
  for (const std::string& note : report.notes) line += ", " + note;
  return without_controls(line) + '\n';
}

}  // namespace

BatchReport::BatchReport(const Options& options, Streams streams)
    : streams_(streams),
      lists_(options.lists),
      has_text_(!is_stdout(options.json) && !is_stdout(options.ndjson)),
      has_json_(options.json.has_value()),
      json_is_stdout_(is_stdout(options.json)),
      ndjson_is_stdout_(is_stdout(options.ndjson)) {
  if (options.json && !json_is_stdout_) json_.emplace(options.json->file);
  if (options.ndjson && !ndjson_is_stdout_) ndjson_.emplace(options.ndjson->file);
}

void BatchReport::add(const std::string& path, const RepairReport& report) {
  n_changed_ += report.result.log.steps.empty() ? 0 : 1;
  n_with_rest_ += nothing_remains(report) ? 0 : 1;
  for (std::size_t code = 0; code < kDefectCodes; ++code) {
    before_[code] += report.result.before.counts[code];
    for (const FinalMesh& mesh : report.meshes) after_[code] += mesh.remaining.counts[code];
  }
  lost_.insert(lost_.end(), report.lost.begin(), report.lost.end());
  lost_ = summed(std::move(lost_));
  if (has_json_ || ndjson_ || ndjson_is_stdout_) add_json(on_one_line(json_report(report)));
  if (lists_ == ListLength::Full) {
    say((n_files_ == 0 ? "" : "\n") + text_report(report, lists_));
  } else {
    say(file_line(path, report));
  }
  ++n_files_;
}

void BatchReport::add_error(const std::string& path, const std::string& what) {
  ++n_errors_;
  add_json(on_one_line(error_json(path, what)));
  ++n_files_;
}

void BatchReport::add_json(const std::string& report) {
  const std::string begin =
      n_files_ == 0 ? "{\"schema\": \"meshfixer-batch/1\", \"reports\": [\n" : ",\n";
  if (json_) json_->write(begin + report);
  if (json_is_stdout_) streams_.out << begin << report;
  if (ndjson_) ndjson_->write(report + '\n');
  if (ndjson_is_stdout_) streams_.out << report << std::endl;
}

void BatchReport::say(const std::string& text) {
  if (has_text_) streams_.out << text << std::flush;
}

std::string BatchReport::table() const {
  std::string text = "\nDEFECTS BEFORE AND AFTER\n";
  std::size_t n_before = 0;
  std::size_t n_after = 0;
  for (const DefectCode code : all_defect_codes()) {
    const auto i = static_cast<std::size_t>(code);
    n_before += before_[i];
    n_after += after_[i];
    if (before_[i] + after_[i] == 0) continue;
    text += std::string(defect_name(code)) + ": " + arrow(before_[i], after_[i]) + '\n';
  }
  text += "defects: " + arrow(n_before, n_after) + '\n';
  text += "\nFILES\n";
  text += "files: " + std::to_string(n_files_) + '\n';
  text += "changed: " + std::to_string(n_changed_) + '\n';
  text += "with defects left that were asked for: " + std::to_string(n_with_rest_) + '\n';
  text += "not read or not written: " + std::to_string(n_errors_) + '\n';
  if (!lost_.empty()) text += "lost: " + lost_text(lost_) + '\n';
  return text;
}

void BatchReport::finish() {
  const std::string end =
      n_files_ == 0 ? "{\"schema\": \"meshfixer-batch/1\", \"reports\": []}\n" : "\n]}\n";
  if (json_) {
    json_->write(end);
    json_->commit();
  }
  if (json_is_stdout_) streams_.out << end << std::flush;
  if (ndjson_) ndjson_->commit();
  say(table());
}

}  // namespace meshalyzer::fixer
