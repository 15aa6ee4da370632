#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/write.h"
#include "support/packed_sets.h"

#include <filesystem>
#include <iostream>
#include <optional>
#include <span>

namespace meshalyzer {
namespace {

struct Arguments {
  std::filesystem::path folder;
  test::PackOptions options;
};

/// The set has examples of every relation that two objects can have.
std::optional<Arguments> parse(std::span<char*> words) {
  if (words.size() != 4) {
    return std::nullopt;
  }
  const auto n = parse_integer(words[2]);
  const auto faces = parse_integer(words[3]);
  if (!n || *n < 1 || !faces || *faces < 1) {
    return std::nullopt;
  }
  Arguments arguments{words[1], {}};
  arguments.options.n_objects = static_cast<std::size_t>(*n);
  arguments.options.faces_per_object = static_cast<std::size_t>(*faces);
  arguments.options.n_crossing = 1;
  arguments.options.n_touching = 1;
  arguments.options.n_contained = 1;
  return arguments;
}

void write(const Arguments& arguments) {
  const test::PackedSet set = test::pack_tubes(arguments.options);
  for (std::size_t i = 0; i < set.objects.size(); ++i) {
    write_mesh(set.objects[i], (arguments.folder / set.names[i]).string());
  }
}

}  // namespace
}  // namespace meshalyzer

/// write_packed_set FOLDER N FACES_PER_OBJECT: writes N tubes that lie close together, one a file,
/// into a folder that is there. Two of them cross, two touch, and one is inside another.
int main(int argc, char** argv) {
  try {
    const auto arguments = meshalyzer::parse({argv, static_cast<std::size_t>(argc)});
    if (!arguments) {
      std::cerr << "usage: write_packed_set FOLDER N FACES_PER_OBJECT\n";
      return 2;
    }
    meshalyzer::write(*arguments);
  } catch (const meshalyzer::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
