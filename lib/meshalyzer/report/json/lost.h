#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/report/json/writer.h"

#include <span>

namespace meshalyzer {

/// Writes the member "lost": the number of attributes of each kind that the output cannot hold.
inline void write_lost(JsonWriter& json, std::span<const AttributeCount> lost) {
  json.key("lost");
  json.begin_object(JsonLayout::Row);
  for (const AttributeCount& count : lost) json.member(attribute_key(count.kind), count.count);
  json.end_object();
}

}  // namespace meshalyzer
