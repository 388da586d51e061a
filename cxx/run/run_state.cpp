// What a run is after an accepted step, and going on from it.
#include "base/error.hpp"
#include "run/stepper.hpp"

namespace burnish {

template <int Dim> RunState<Dim> Stepper<Dim>::state() const {
  std::vector<std::vector<Prescription::Entry>> drives;
  for (const auto& tool : m_contact.setup().tools()) drives.push_back(tool->prescription().entries());
  return {m_body.state(), m_contact.state(), m_control.state(), m_counts,     m_diagnosis,
          drives,         m_options.scheme,  m_last_rejection,  m_rejected_dt};
}

template <int Dim>
void Stepper<Dim>::set_state(const RunState<Dim>& state, Eigen::VectorXd& u, Eigen::VectorXd& R) {
  const auto& tools = m_contact.setup().tools();
  require(state.drives.size() == tools.size(), "Stepper", "number of tools in the state", state.drives.size(),
          std::to_string(tools.size()).c_str());
  for (std::size_t t = 0; t < tools.size(); ++t) tools[t]->prescription().set_entries(state.drives[t]);
  m_body.set_state(state.body);
  m_contact.set_state(state.contact);
  const ContactRunState<Dim>& at = state.contact;
  if (at.history.dt > 0) m_contact.iteration().balance().look(at.contact, at.prescribed, at.u, at.R);
  m_control.set_state(state.control);
  m_counts = state.counts;
  m_diagnosis = state.diagnosis;
  m_options.scheme = state.scheme;
  m_last_rejection = state.last_rejection;
  m_rejected_dt = state.rejected_dt;
  u = state.contact.u;
  R = state.contact.R;
  m_phase = Phase::STEP;
  m_stopped = m_refused = false;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template RunState<Dim> Stepper<Dim>::state() const;                                                        \
  template void Stepper<Dim>::set_state(const RunState<Dim>&, Eigen::VectorXd&, Eigen::VectorXd&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
