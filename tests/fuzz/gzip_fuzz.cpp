#include "check_parser.h"
#include "meshalyzer/io/gzip.h"
#include "meshalyzer/io/read.h"

namespace meshalyzer {
namespace {

/// Any bytes behind the beginning of a gzipped file are refused or unpacked, and what is packed is
/// what was to be packed.
void check_gzip(std::string_view content) {
  try {
    static_cast<void>(unpack_gzip("\x1f\x8b\x08" + std::string(content), "fuzz"));
  } catch (const IoError&) {  // refused
  }
  const UnpackLimit limit(1'000'000);
  if (unpack_gzip(pack_gzip(content), "packed") != content) {
    std::abort();
  }
}

/// Any bytes, whatever the name, are refused or make a well-formed soup.
void check_reading(std::string_view content) {
  for (const char* name : {"a.mesh", "a.obj.gz", "a.off", "a.stl", "a.ply", "-"}) {
    try {
      if (!is_well_formed(parse_mesh(content, name))) {
        std::abort();
      }
    } catch (const IoError&) {  // refused
    }
  }
}

}  // namespace
}  // namespace meshalyzer

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  meshalyzer::check_gzip(meshalyzer::as_text(data, size));
  meshalyzer::check_reading(meshalyzer::as_text(data, size));
  return 0;
}
