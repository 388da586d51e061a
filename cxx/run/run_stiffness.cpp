#include "run/run_stiffness.hpp"
#include "base/error.hpp"

namespace burnish {

template <int Dim> void RunStiffness<Dim>::require_accepted() const {
  if (m_run.accepted().history.dt == 0)
    fail(m_where, "no step has been accepted yet, expected an accepted state");
  if (m_run.step().stage != StepUnderWay<Dim>::Stage::NONE)
    fail(m_where, "a step is under way, expected an accepted state: ask in record, or after the run");
}

template <int Dim> Eigen::MatrixXd RunStiffness<Dim>::driven(const NodeBlockMatrix<Dim>& K) {
  require_accepted();
  const ContactRunState<Dim>& at = m_run.accepted();
  require(K.size() == at.u.size(), m_where, "size of the tangent", K.size(),
          ("number of degrees of freedom, " + std::to_string(at.u.size())).c_str());
  NodeBlockMatrix<Dim> copy;
  const NodeBlockMatrix<Dim>& sprung = m_run.loads().with_springs(K, at.prescribed.t, copy);
  const Eigen::MatrixXd held = m_stiffness.held({sprung, at.contact, at.u, at.R});
  return driven_stiffness(m_run.setup().model(), held, at.prescribed, at.contact.q);
}

template <int Dim> Eigen::MatrixXd RunStiffness<Dim>::driven(const Workpiece<Dim>& workpiece, bool elastic) {
  require_accepted();
  if (workpiece.user_defined())
    fail(m_where,
         "the law is the script's, expected tangent=, the matrix of its tangent at the accepted state");
  if (m_K.num_nodes == 0) m_K = workpiece.pattern();
  workpiece.tangent(m_K, elastic ? TangentKind::ELASTIC : TangentKind::RATE);
  return driven(m_K);
}

template <int Dim>
int RunStiffness<Dim>::coordinate(const DrivenTool<Dim>& tool, const std::string& name) const {
  const auto& tools = m_run.setup().tools();
  const ContactModel<Dim>& model = m_run.setup().model();
  const int at = tool.index(name);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (tools[t].get() != &tool) continue;
    const int k = model.first[t] + at;
    if (model.coupling_of(k))
      fail(m_where, model.coordinate(k) + " follows others, expected one that they follow");
    return k;
  }
  fail(m_where, "tool \"" + tool.name() + "\" belongs to no contact, expected one that was added");
}

template class RunStiffness<2>;
template class RunStiffness<3>;

} // namespace burnish
