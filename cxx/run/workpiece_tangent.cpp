#include "run/workpiece_tangent.hpp"
#include "base/error.hpp"

namespace burnish {

namespace {

template <int Dim> void require_alike(const ContactRun<Dim>& contact, const Workpiece<Dim>& workpiece) {
  const Mesh<Dim>& mesh = contact.setup().mesh();
  const int size = workpiece.discretization().num_dofs();
  require(size == mesh.num_dofs(), "contact.factorize", "degrees of freedom of the material", size,
          (std::to_string(mesh.num_dofs()) + " as the contact's space").c_str());
  if (workpiece.discretization().axisymmetric != mesh.axisymmetric)
    fail("contact.factorize",
         "material and contact disagree: give axisymmetric= to both rcMaterial and rcContact");
}

} // namespace

template <int Dim>
bool factorize_tangent(ContactRun<Dim>& contact, const Workpiece<Dim>& workpiece, const Eigen::VectorXd& u) {
  require_alike(contact, workpiece);
  contact.corrector().forget_mixing();
  do {
    NodeBlockMatrix<Dim> K = workpiece.pattern();
    workpiece.tangent(K, TangentKind::DAMPED, contact.iteration().policy().elastic_blend());
    if (contact.factorize(std::move(K), u) == FactorStatus::OK) return true;
  } while (!contact.iteration().policy().blend_exhausted());
  return false;
}

template <int Dim>
bool take_tangent(ContactRun<Dim>& contact, const Workpiece<Dim>& workpiece, Eigen::VectorXd& u) {
  require_alike(contact, workpiece);
  Iteration<Dim>& iteration = contact.iteration();
  CondensedStep<Dim>& condensed = contact.condensed();
  const bool may = contact.step().stepping == Stepping::IMPLICIT && contact.corrector().own_solver();
  if (!may) return factorize_tangent(contact, workpiece, u);
  if (!condensed.pays([&] { return workpiece.pattern(); })) {
    iteration.policy().set_condensed(false);
    return factorize_tangent(contact, workpiece, u);
  }
  NodeBlockMatrix<Dim> K = workpiece.pattern();
  workpiece.tangent(K, TangentKind::CONSISTENT, iteration.policy().elastic_blend());
  contact.corrector().measure(K);
  return condensed.iterate(K, workpiece.internal_force(), u) || factorize_tangent(contact, workpiece, u);
}

template bool take_tangent<2>(ContactRun<2>&, const Workpiece<2>&, Eigen::VectorXd&);
template bool take_tangent<3>(ContactRun<3>&, const Workpiece<3>&, Eigen::VectorXd&);
template bool factorize_tangent<2>(ContactRun<2>&, const Workpiece<2>&, const Eigen::VectorXd&);
template bool factorize_tangent<3>(ContactRun<3>&, const Workpiece<3>&, const Eigen::VectorXd&);

} // namespace burnish
