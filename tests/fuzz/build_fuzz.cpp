#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/validate.h"

#include <cstddef>
#include <cstdint>

/// The first byte is the number of vertices, at most 16; then three bytes a face, whose last value
/// stands for a missing vertex. No input may crash, and the independent checker may find no fault.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const unsigned n_vertices = 1U + data[0] % 16U;
  meshalyzer::Soup soup;
  for (unsigned i = 0; i < n_vertices; ++i) soup.positions.emplace_back(i, i * i, i * i * i);
  for (std::size_t i = 1; i + 3 <= size; i += 3) {
    meshalyzer::Triangle triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const unsigned value = data[i + corner] % (n_vertices + 1U);
      triangle[corner] = value == n_vertices ? meshalyzer::kNoIndex : value;
    }
    soup.triangles.push_back(triangle);
  }
  if (!meshalyzer::validate(meshalyzer::build(soup), soup).empty()) __builtin_trap();
  return 0;
}
