#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/write.h"
#include "support/tube_packing.h"

#include <filesystem>
#include <iostream>
#include <optional>
#include <span>
#include <system_error>

namespace meshalyzer {
namespace {

/// N FACES_PER_OBJECT [GAP] [SEED]; nothing where that is not what the arguments are.
std::optional<test::PackOptions> options_from(std::span<char*> arguments) {
  if (arguments.size() < 2 || arguments.size() > 4) return std::nullopt;
  const auto n = parse_integer(arguments[0]);
  const auto faces = parse_integer(arguments[1]);
  if (!n || *n < 1 || !faces || *faces < 1) return std::nullopt;
  test::PackOptions options;
  options.n_objects = static_cast<std::size_t>(*n);
  options.faces_per_object = static_cast<std::size_t>(*faces);
  if (arguments.size() > 2) {
    const auto gap = parse_real(arguments[2]);
    if (!gap) return std::nullopt;
    options.gap = *gap;
  }
  if (arguments.size() > 3) {
    const auto seed = parse_integer(arguments[3]);
    if (!seed) return std::nullopt;
    options.seed = static_cast<std::uint32_t>(*seed);
  }
  return options;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw IoError(folder.string(), {}, failure.message());
}

void write_set(const std::filesystem::path& folder, const test::PackOptions& options) {
  const test::TubePacking packing(options);
  make_folder(folder);
  parallel_chunks(options.n_objects, 1, [&](Chunk chunk) {
    const std::string name = test::object_name(chunk.number, options.n_objects);
    write_mesh(packing.object(chunk.number), (folder / name).string());
  });
}

}  // namespace
}  // namespace meshalyzer

/// make_set FOLDER N FACES_PER_OBJECT [GAP] [SEED]: writes N tubes that wind through each other's
/// boxes, one a file, none nearer to another than GAP (their radius is 1). They fill a box that
/// grows with N, always equally dense.
int main(int argc, char** argv) {
  try {
    const std::span arguments(argv, static_cast<std::size_t>(argc));
    const auto options = argc > 2 ? meshalyzer::options_from(arguments.subspan(2)) : std::nullopt;
    if (!options) {
      std::cerr << "usage: make_set FOLDER N FACES_PER_OBJECT [GAP] [SEED]\n";
      return 2;
    }
    meshalyzer::write_set(argv[1], *options);
  } catch (const meshalyzer::Error& e) {
    std::cerr << e.what() << '\n';
    return 2;
  }
  return 0;
}
