#pragma once

#include "meshalyzer/repair/pass.h"

namespace meshalyzer {

/// Returns a pass that proposes what another one does, and computes it once for two requests in
/// succession: what it was asked for one mesh, with the same fixed vertices, it remembers until it
/// is asked again. So a pass can try what another would do, and that one need not do all of it
/// again.
///
/// Only proposals for operations of normal size, and for meshes with a number, are remembered.
/// Copies of the pass share what they remember.
[[nodiscard]] PassFunction remembered_pass(PassFunction pass);

}  // namespace meshalyzer
