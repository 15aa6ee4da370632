#pragma once

#include "meshalyzer/repair/driver/internal/applied_operations.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The keys of the elements that an operation changes, and the number of walls it declares, which
/// identify it when it is proposed again.
using OperationSignature = std::vector<Index>;

/// Two hashes of all that an operation does: the faces that go, with their corners, and those that
/// come. An operation with the same hashes does the same, bit for bit.
using OperationHash = std::array<std::uint64_t, 2>;

/// Returns the site of each operation.
[[nodiscard]] std::vector<OperationSite> sites_of(const TrackedMesh& tracked, const Edits& edits);

/// Returns the signature of each operation.
[[nodiscard]] std::vector<OperationSignature> signatures_of(const TrackedMesh& tracked,
                                                            const Edits& edits);

/// Returns the hashes of each operation.
[[nodiscard]] std::vector<OperationHash> hashes_of(const TrackedMesh& tracked, const Edits& edits);

}  // namespace meshalyzer
