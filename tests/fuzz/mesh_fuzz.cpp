#include "check_parser.h"
#include "meshalyzer/io/mesh_format.h"

namespace {

/// Parts of a few bytes, so that records lie across their borders.
meshalyzer::Soup parse_in_small_parts(std::string_view text, const std::string& name) {
  return meshalyzer::parse_mesh_format(text, name, {.bytes_per_part = 16});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  meshalyzer::check_parser(meshalyzer::as_text(data, size), parse_in_small_parts,
                           meshalyzer::print_mesh_format);
  return 0;
}
