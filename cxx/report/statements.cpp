#include "report/statements.hpp"
#include "checks/known_law.hpp"
#include <algorithm>
#include <sstream>

namespace burnish {
namespace {

// What costs nothing, since it is left out of itself.
template <int Dim> Statement lean(const ReportedRun<Dim>& run) {
  const AcceptedStep<Dim>& step = run.step;
  const Eigen::Index all = step.contact.q.size();
  Eigen::Index given = 0;
  for (Eigen::Index k = 0; k < all; ++k)
    given +=
        step.model.coupling_of(static_cast<int>(k)) || (step.prescribed && step.prescribed->is_motion[k]);
  std::ostringstream text;
  text << given << " of " << all << " coordinates are prescribed at the end and carry no equation";
  if (run.scene.window > 0)
    text << "; at most " << run.scene.window << " of " << step.model.candidates.size()
         << " contact nodes took part in the contact iteration";
  if (known_law(step.workpiece)) {
    const auto strains = plastic_strains(step.workpiece);
    text << "; " << (strains.array() > 0).count() << " of " << strains.size() << " points ever flowed";
  }
  if (step.model.symmetric()) text << "; without friction the matrix is symmetric";
  return {StatementKind::LEAN, "lean", static_cast<double>(given), 0, text.str()};
}

} // namespace

const char* name_of(StatementKind kind) {
  switch (kind) {
  case StatementKind::NEEDED:
    return "needed and not modelled";
  case StatementKind::NOT_NEEDED:
    return "modelled and not needed";
  case StatementKind::LEAN:
    break;
  }
  return "lean";
}

std::string short_number(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

template <int Dim> std::vector<Statement> statements(const ReportedRun<Dim>& run) {
  if (run.scene.steps == 0) return {};
  std::vector<Statement> list = not_modelled(run);
  for (Statement& statement : modelled_in_vain(run)) list.push_back(std::move(statement));
  list.push_back(lean(run));
  std::stable_sort(list.begin(), list.end(),
                   [](const Statement& a, const Statement& b) { return a.importance > b.importance; });
  if (list.size() > static_cast<std::size_t>(run.options.most)) list.resize(run.options.most);
  return list;
}

template std::vector<Statement> statements<2>(const ReportedRun<2>&);
template std::vector<Statement> statements<3>(const ReportedRun<3>&);

} // namespace burnish
