#include "meshalyzer/report/json/format.h"

#include "meshalyzer/base/find_named.h"
#include "meshalyzer/report/format_text.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

namespace meshalyzer {
namespace {

constexpr std::array kFormats{Format::Mesh, Format::Inria, Format::Obj,
                              Format::Off,  Format::Stl,   Format::Ply};

}  // namespace

void write_format(JsonWriter& json, std::string_view path, Format format) {
  json.member("format", format_name(format));
  if (const std::string_view misleading = misleading_format(path, format); !misleading.empty()) {
    json.member("named_format", misleading);
  }
}

std::vector<SchemaMember> format_members() {
  std::vector<std::string_view> formats;
  std::transform(kFormats.begin(), kFormats.end(), std::back_inserter(formats), format_name);
  return {{"format", "what it was read as", schema_enum(formats)},
          {"named_format",
           "only where the content is of another format than the ending of the name: that one",
           schema_enum(formats), SchemaMember::Presence::Sometimes}};
}

Format read_format(const JsonNode& node) {
  const std::optional<Format> format = find_named(kFormats, node.text(), format_name);
  if (!format) {
    node.refuse("no format of meshes");
  }
  return *format;
}

}  // namespace meshalyzer
