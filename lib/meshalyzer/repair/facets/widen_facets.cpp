#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/step_contacts.h"
#include "meshalyzer/repair/facets/internal/step_journal.h"
#include "meshalyzer/repair/facets/internal/widen_facet.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/facets/turning_over.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/passes.h"

#include <vector>

namespace meshalyzer {

PassResult widen_facets(const PassInput& input, TurningOver turning) {
  const Soup& soup = input.tracked.soup;
  std::vector<Index> thin;
  for (const Defect& defect : find_thin_facets(input.mesh, input.tolerances)) {
    const Index f = defect.faces.front();
    if (is_in_complex(soup.triangles[f])) thin.push_back(f);
  }
  PassResult result;
  if (thin.empty()) return result;
  WorkingMesh mesh(soup, thin, input.tolerances.degeneracy);
  const StepContacts contacts(input.mesh, mesh);
  const MendRules rules(input, &contacts);
  StepJournal journal(input.operation_size);
  for (const Index f : thin) {
    if (input.wants_to_stop()) break;
    if (!mesh.is_thin(f)) continue;
    const MendAttempt attempt = widen_facet(mesh, rules, f, turning);
    if (attempt.is_possible() && journal.record(mesh, attempt.step)) mesh.make(attempt.step);
  }
  result.edits = journal.edits(soup, mesh);
  result.has_smaller_operations = true;
  return result;
}

}  // namespace meshalyzer
