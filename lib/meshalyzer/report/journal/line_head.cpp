#include "meshalyzer/base/find_named.h"
#include "meshalyzer/report/journal/head_members.h"
#include "meshalyzer/report/journal/line.h"
#include "meshalyzer/report/journal/line_kind.h"
#include "meshalyzer/report/journal/request.h"
#include "meshalyzer/report/utf8.h"

#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

LineHead::Kind kind_of(const HeadMembers& members) {
  const auto kind = find_named(kLineKinds, members.get<std::string>("kind"), kind_name);
  if (!kind) {
    HeadMembers::refuse("kind");
  }
  return *kind;
}

std::string path_of(const HeadMembers& members) {
  if (members.find("path_bytes") == nullptr) {
    return members.get<std::string>("path");
  }
  std::optional<std::string> bytes = utf8_to_latin1(members.get<std::string>("path_bytes"));
  if (!bytes) {
    HeadMembers::refuse("path_bytes");
  }
  return *std::move(bytes);
}

}  // namespace

LineHead read_head(std::string_view line) {
  const HeadMembers members(line);
  return {.kind = kind_of(members),
          .number = members.count("number"),
          .of = members.count("of"),
          .path = path_of(members),
          .stamp = {members.count("bytes"), members.get<std::int64_t>("modified")},
          .request = read_request(members, "asked"),
          .set = members.get<std::string>("set")};
}

}  // namespace meshalyzer
