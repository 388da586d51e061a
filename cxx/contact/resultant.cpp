#include "contact/resultant.hpp"

namespace burnish {

template <int Dim> Resultant<Dim>& Resultant<Dim>::operator+=(const Resultant& other) {
  force += other.force;
  moment += other.moment;
  return *this;
}

template <int Dim>
Resultant<Dim> resultant(const BodyView<Dim>& body, const Eigen::VectorXd& u, const Eigen::VectorXd& f,
                         const Vector<Dim>& about, const std::vector<int>& nodes) {
  Resultant<Dim> sum;
  const auto add = [&](int node) {
    const Vector<Dim> F = f.segment<Dim>(Dim * node), arm = body.position(u, node) - about;
    sum.force += F;
    if constexpr (Dim == 2)
      sum.moment[0] += arm[0] * F[1] - arm[1] * F[0];
    else
      sum.moment += arm.cross(F);
  };
  for (const int node : nodes) add(node);
  for (int node = 0; nodes.empty() && node < static_cast<int>(body.X.size()) / Dim; ++node) add(node);
  return sum;
}

template <int Dim> Resultant<Dim> of_ring(const Resultant<Dim>& section) {
  Resultant<Dim> ring;
  ring.force[1] = section.force[1]; // y runs along the axis
  return ring;
}

template <int Dim>
Eigen::VectorXd contact_forces(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                               const Eigen::VectorXd& R, int tool) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(R.size());
  const auto poses = model.poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    const bool pressed = in_contact(node.state) || node.state == NodeState::LEAVING;
    if (!pressed || (tool >= 0 && node.tool != tool)) continue;
    const int candidate = static_cast<int>(i), dof = Dim * model.candidates[i];
    const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
    forces.segment<Dim>(dof) = nodal_force(model, candidate, p, Vector<Dim>(R.segment<Dim>(dof))).F;
  }
  return forces;
}

template <int Dim>
Eigen::VectorXd support_forces(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                               const ContactState<Dim>& state, const Eigen::VectorXd& R) {
  Eigen::VectorXd forces = R - contact_forces(model, state, R);
  for (Eigen::Index d = 0; d < R.size(); ++d)
    if (!body.fixed[d]) forces[d] = 0;
  return forces;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template struct Resultant<Dim>;                                                                            \
  template Resultant<Dim> resultant<Dim>(const BodyView<Dim>&, const Eigen::VectorXd&,                       \
                                         const Eigen::VectorXd&, const Vector<Dim>&,                         \
                                         const std::vector<int>&);                                           \
  template Resultant<Dim> of_ring<Dim>(const Resultant<Dim>&);                                               \
  template Eigen::VectorXd contact_forces<Dim>(const ContactModel<Dim>&, const ContactState<Dim>&,           \
                                               const Eigen::VectorXd&, int);                                 \
  template Eigen::VectorXd support_forces<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,               \
                                               const ContactState<Dim>&, const Eigen::VectorXd&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
