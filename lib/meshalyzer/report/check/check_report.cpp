#include "meshalyzer/report/check/check_report.h"

#include "meshalyzer/base/find_named.h"
#include "meshalyzer/report/check/formats.h"

#include <array>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::array kCheckFormats{CheckFormat::Text,  CheckFormat::Json,  CheckFormat::Ndjson,
                                   CheckFormat::Sarif, CheckFormat::Junit, CheckFormat::Github};

}  // namespace

std::span<const CheckFormat> all_check_formats() {
  return kCheckFormats;
}

std::string_view check_format_name(CheckFormat format) {
  constexpr std::array<std::string_view, kCheckFormats.size()> kNames{"text",  "json",  "ndjson",
                                                                      "sarif", "junit", "github"};
  return kNames[static_cast<std::size_t>(format)];
}

std::optional<CheckFormat> check_format(std::string_view name) {
  return find_named(kCheckFormats, name, check_format_name);
}

std::unique_ptr<CheckReport> make_check_report(CheckFormat format, TextSink sink,
                                               TextColour colour) {
  switch (format) {
    case CheckFormat::Json:
      return make_check_json(std::move(sink));
    case CheckFormat::Ndjson:
      return make_check_ndjson(std::move(sink));
    case CheckFormat::Sarif:
      return make_check_sarif(std::move(sink));
    case CheckFormat::Junit:
      return make_check_junit(std::move(sink));
    case CheckFormat::Github:
      return make_check_github(std::move(sink));
    case CheckFormat::Text:
      break;
  }
  return make_check_text(std::move(sink), colour);
}

}  // namespace meshalyzer
