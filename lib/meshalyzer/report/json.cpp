#include "meshalyzer/report/json.h"

#include "meshalyzer/report/json_report.h"

namespace meshalyzer {

std::string json_report(std::span<const Analysis> meshes, const SetAnalysis* set,
                        JsonOffenders offenders) {
  std::string text;
  JsonReport report([&](std::string_view piece) { text += piece; }, offenders);
  for (const Analysis& mesh : meshes) {
    report.add(mesh);
  }
  report.finish(set);
  return text;
}

}  // namespace meshalyzer
