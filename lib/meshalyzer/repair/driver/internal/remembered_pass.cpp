#include "meshalyzer/repair/driver/internal/remembered_pass.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// A proposal for the mesh with a number, and the vertices that were fixed then.
struct Remembered {
  std::size_t mesh_number = 0;
  std::vector<std::uint8_t> fixed_vertices;
  PassResult proposal;

  [[nodiscard]] bool answers(const PassInput& input) const {
    return mesh_number == input.mesh_number && fixed_vertices == input.limits.fixed_vertices;
  }
};

}  // namespace

PassFunction remembered_pass(PassFunction pass) {
  auto last = std::make_shared<std::optional<Remembered>>();
  return [last = std::move(last), pass = std::move(pass)](const PassInput& input) {
    const std::optional<Remembered> known = std::exchange(*last, std::nullopt);
    const bool is_rememberable =
        input.mesh_number != 0 && input.operation_size == OperationSize::Normal;
    if (!is_rememberable) return pass(input);
    if (known && known->answers(input)) return known->proposal;
    PassResult proposal = pass(input);
    // A pass that was stopped has not proposed all.
    if (!input.wants_to_stop()) {
      *last = Remembered{input.mesh_number, input.limits.fixed_vertices, proposal};
    }
    return proposal;
  };
}

}  // namespace meshalyzer
