#include "diagnosis/accepted_step.hpp"
#include "base/sentence.hpp"
#include "diagnosis/findings.hpp"

namespace burnish {

template <int Dim> Vector<Dim> AcceptedStep<Dim>::point(int p) const {
  const Discretization<Dim>& space = workpiece->discretization();
  const int* nodes = mesh().element(p / space.points_per_element);
  Vector<Dim> x = Vector<Dim>::Zero();
  for (int a = 0; a < mesh().nodes_per_element; ++a) x += space.shapes(p)[a] * body().position(u, nodes[a]);
  return x;
}

template <int Dim> std::string AcceptedStep<Dim>::at(const Vector<Dim>& x) const {
  return sentence(" at ", place_text(place_of(x)), ", t = ", t);
}

template <int Dim> void prepare(AcceptedStep<Dim>& step, long number, bool checks) {
  const ContactModel<Dim>& model = step.model();
  step.number = number;
  step.poses = model.poses(step.contact.q);
  step.touching.clear();
  const auto deciding = deciding_forces(model, step.contact, step.poses, step.R);
  for (std::size_t i = 0; i < step.contact.nodes.size(); ++i) {
    const ContactNode<Dim>& node = step.contact.nodes[i];
    if (!in_contact(node.state)) continue;
    CheckedNode<Dim> touching;
    touching.candidate = static_cast<int>(i);
    touching.at = contact_point(model, step.poses, node);
    const int mesh_node = model.candidates[i];
    const Vector<Dim> R = step.R.template segment<Dim>(Dim * mesh_node);
    touching.force = nodal_force(model, touching.candidate, touching.at.surface, R);
    touching.deciding = deciding[i];
    touching.x = step.body().position(step.u, mesh_node);
    step.touching.push_back(std::move(touching));
  }
  if (step.workpiece && checks) step.internal = step.workpiece->internal_force();
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template struct AcceptedStep<Dim>;                                                                         \
  template void prepare<Dim>(AcceptedStep<Dim>&, long, bool);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
