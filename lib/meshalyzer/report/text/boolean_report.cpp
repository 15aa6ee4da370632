#include "meshalyzer/report/text/boolean_report.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/repair_lines.h"

#include <fmt/format.h>
#include <utility>

namespace meshalyzer {
namespace {

std::string kept_text(const BooleanOperand& operand) {
  return fmt::format("{} whole, {} in parts, {} gone", counted(operand.n_whole, "face", "faces"),
                     grouped(operand.n_cut), grouped(operand.n_gone));
}

void append_operand(LineSink& lines, const BooleanOperand& operand) {
  lines.line("operand", operand.name);
  lines.line("faces", operand.n_faces);
  lines.line("volume", operand.volume);
  lines.line("kept", kept_text(operand));
}

void append_output(LineSink& lines, const BooleanOutput& output) {
  lines.line("written", output.path.empty() ? "nothing" : output.path);
  lines.line("vertices", output.n_vertices);
  lines.line("faces", output.n_faces);
  lines.line("volume", output.volume);
  lines.line("largest move", output.largest_move);
  lines.line("verdict", output.verdict);
}

}  // namespace

std::string text_report(const BooleanReport& report) {
  TextLines lines;
  lines.heading("BOOLEAN OPERATION");
  lines.line("operation", operation_name(report.operation));
  lines.line("intersecting pairs", report.n_pairs);
  for (const std::string& note : report.notes) lines.line("note", note);
  if (!report.lost.empty()) lines.line("lost", lost_text(report.lost));
  lines.heading("OPERANDS");
  for (const BooleanOperand& operand : report.operands) append_operand(lines, operand);
  lines.heading("RESULT");
  for (const BooleanOutput& output : report.outputs) append_output(lines, output);
  return std::move(lines.text());
}

}  // namespace meshalyzer
