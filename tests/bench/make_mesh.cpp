#include "big_meshes.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/write.h"

#include <iostream>

/// make_mesh KIND FACES FILE: writes one of the meshes that doc/benchmarks.md measures.
int main(int argc, char** argv) {
  try {
    const auto faces = argc == 4 ? meshalyzer::parse_integer(argv[2]) : std::nullopt;
    if (!faces || *faces < 1) {
      std::cerr
          << "usage: make_mesh wavy|shuffled|damaged|flat|subdivided|cad|slivers|beam|crossing"
             "|fan|onion|shards|orphans|tangle FACES FILE\n";
      return 2;
    }
    meshalyzer::write_mesh(meshalyzer::bench::big_mesh(argv[1], static_cast<std::size_t>(*faces)),
                           argv[3]);
  } catch (const meshalyzer::Error& e) {
    std::cerr << e.what() << '\n';
    return 2;
  }
  return 0;
}
