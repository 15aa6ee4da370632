#include "check_parser.h"
#include "meshalyzer/io/inria.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  meshalyzer::check_parser(meshalyzer::as_text(data, size), meshalyzer::parse_inria,
                           meshalyzer::print_inria);
  return 0;
}
