#pragma once

#include "meshalyzer/repair/fix_defects.h"

namespace meshalyzer {

// Laws that hold for every repair, each expected by GoogleTest. The mesh is named by a scoped
// trace.

/// Repairing what came out changes nothing, and nothing is logged.
void expect_done(const RepairResult& result, const RepairOptions& options);

/// Expects that the log names, with a reason, every remaining defect that should have been fixed.
void expect_reasons(const RepairResult& result, const RepairOptions& options);

/// Faces and vertices that have come, gone or changed are in the log.
void expect_log_complete(const Soup& input, const RepairResult& result);

/// Expects that elements that the log does not name are unchanged bit for bit.
void expect_rest_untouched(const Soup& input, const RepairResult& result);

/// No count of defects is higher than before, and the mesh is still closed, manifold, consistent
/// and outward where it was. A non-manifold edge less may leave one border edge and one pinched
/// vertex. Counted in the plainest way.
void expect_never_worse(const Soup& input, const RepairResult& result,
                        const RepairOptions& options);

/// Dense samples of either surface are within the bound, and within what was measured, of the
/// other; hole patches are left out.
void expect_within_deviation(const Soup& input, const RepairResult& result);

/// The half-edge mesh of the result holds together, and its records refer to what there is.
void expect_valid(const RepairResult& result);

}  // namespace meshalyzer
