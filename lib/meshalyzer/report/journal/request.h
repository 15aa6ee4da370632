#pragma once

#include "meshalyzer/report/journal/head_members.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/set/request.h"

#include <string>

namespace meshalyzer {

/// Writes what was asked as one JSON object: the version of the library, as another one may find
/// otherwise, and those members of the request that are not as in Request{}, in the order and with
/// the keys of kRequestFields.
void write_request(JsonWriter& json, const Request& request);

/// Returns what write_request() writes, as a text.
[[nodiscard]] std::string request_text(const Request& request);

/// Reads what write_request() wrote.
///
/// @param key  Of the object among the members.
/// @throws InvalidArgument  where it is none, was written by another version, or has members that
/// no request has.
[[nodiscard]] Request read_request(const HeadMembers& members, const std::string& key);

}  // namespace meshalyzer
