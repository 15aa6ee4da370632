#include "meshalyzer/report/json/boolean_report.h"

#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/lost.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {
namespace {

void write_operand(JsonWriter& json, const BooleanOperand& operand) {
  json.begin_object();
  write_bytes(json, "name", operand.name);
  json.member("faces", operand.n_faces);
  json.member("volume", operand.volume);
  json.key("kept");
  json.begin_object(JsonLayout::Row);
  json.member("whole", operand.n_whole);
  json.member("cut", operand.n_cut);
  json.member("gone", operand.n_gone);
  json.end_object();
  json.end_object();
}

void write_output(JsonWriter& json, const BooleanOutput& output) {
  json.begin_object();
  write_bytes(json, "path", output.path);
  json.member("vertices", output.n_vertices);
  json.member("faces", output.n_faces);
  json.member("volume", output.volume);
  json.member("largest_move", output.largest_move);
  json.member("good", output.is_good);
  json.member("verdict", output.verdict);
  json.end_object();
}

}  // namespace

std::string json_report(const BooleanReport& report) {
  JsonWriter json;
  json.begin_object();
  json.member("schema", "meshfixer-boolean/1");
  json.member("version", MESHALYZER_VERSION);
  json.member("operation", operation_name(report.operation));
  json.member("intersecting_pairs", report.n_pairs);
  json.key("operands");
  json.begin_array();
  for (const BooleanOperand& operand : report.operands) write_operand(json, operand);
  json.end_array();
  json.key("outputs");
  json.begin_array();
  for (const BooleanOutput& output : report.outputs) write_output(json, output);
  json.end_array();
  json.key("notes");
  json.array(report.notes, JsonLayout::Lines);
  write_lost(json, report.lost);
  json.end_object();
  return json.take();
}

}  // namespace meshalyzer
