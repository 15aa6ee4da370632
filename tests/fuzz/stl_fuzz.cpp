#include "check_parser.h"
#include "meshalyzer/io/stl.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meshalyzer;
  check_parser(as_text(data, size), parse_stl, print_ascii_stl);
  return 0;
}
