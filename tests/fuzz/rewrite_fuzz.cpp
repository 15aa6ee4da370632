#include "meshalyzer/base/error.h"
#include "support/random_file_edits.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

namespace meshalyzer {
namespace {

/// The first bytes say which edits are made, the next one the format, and the rest is the file.
constexpr std::size_t kEditBytes = 24;

void check(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<const char*, 6> kNames{"a.mesh", "a.obj", "a.off", "a.stl", "a.ply", "a"};
  std::string content(reinterpret_cast<const char*>(data + kEditBytes), size - kEditBytes);
  std::size_t at = 1;
  const auto next = [&](std::size_t n) {
    return static_cast<Index>(at < kEditBytes ? data[at++] % n : 0);
  };
  std::optional<EditedFile> file;
  try {
    file.emplace(content, kNames[data[0] % kNames.size()]);
  } catch (const IoError&) {
    return;
  }
  if (!file->soup().missing.empty() || file->soup().triangles.empty()) return;
  const std::optional<RewrittenFile> same = file->rewritten();
  if (same && same->bytes != file->bytes()) std::abort();
  edit_at_random(*file, next);
  const std::optional<RewrittenFile> written = file->rewritten();
  if (written && !says_what_was_written(*file, *written, file->read_back())) std::abort();
  for (const Format format : {Format::Mesh, Format::Obj, Format::Off, Format::Stl, Format::Ply}) {
    const RewrittenFile other = file->rewritten_as(format);
    const std::string name = "a." + std::string(format_name(format));
    if (!says_what_was_written(*file, other, parse_mesh(other.bytes, name))) std::abort();
  }
}

}  // namespace
}  // namespace meshalyzer

/// A file of any format and some edits of its mesh. Without edits it must be written as the same
/// bytes, with them, in every format, as a file that is read as the edited mesh.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > meshalyzer::kEditBytes) meshalyzer::check(data, size);
  return 0;
}
