#include "check_parser.h"
#include "meshalyzer/io/ply.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meshalyzer;
  check_parser(as_text(data, size), parse_ply, print_ascii_ply);
  check_parser(as_text(data, size), parse_ply, print_binary_ply);
  return 0;
}
