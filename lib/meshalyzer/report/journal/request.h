#pragma once

#include "meshalyzer/report/journal/head_members.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/set/request.h"

#include <string>

namespace meshalyzer {

/// Writes a request as one JSON object: the version of the library, because the findings of another
/// one may differ, and the members of the request that differ from Request{}, in the order and with
/// the keys of kRequestFields.
void write_request(JsonWriter& json, const Request& request);

/// Returns the text that write_request() writes.
[[nodiscard]] std::string request_text(const Request& request);

/// Reads the request that write_request() wrote.
///
/// @param key  The key of the object among the members.
/// @throws InvalidArgument  if it is none, was written by another version, or has unknown members.
[[nodiscard]] Request read_request(const HeadMembers& members, const std::string& key);

}  // namespace meshalyzer
