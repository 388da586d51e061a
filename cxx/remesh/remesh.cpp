#include "remesh/remesh.hpp"
#include "base/error.hpp"
#include "remesh/contact_transfer.hpp"
#include "remesh/deformed_boundary.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr double BAD_SHAPE = 0.3, WORSE = 0.5;
constexpr double ANY_WORSE = 0.8; // where steps crawl

} // namespace

template <int Dim>
RemeshedRun<Dim> run_on(const Workpiece<Dim>& body, const ContactRun<Dim>& contact, Discretization<Dim> mesh,
                        std::vector<char> fixed) {
  RemeshedRun<Dim> result;
  result.workpiece = std::make_unique<Workpiece<Dim>>(std::move(mesh), body.shared_law(), body.options());
  if (body.user_defined()) result.workpiece->set_user_defined(true);
  result.setup = setup_on<Dim>(contact.setup(), result.workpiece->discretization(), std::move(fixed));
  result.contact = std::make_unique<ContactRun<Dim>>(result.setup, contact.iteration().options());
  return result;
}

template <int Dim>
RemeshedRun<Dim> remeshed(const Workpiece<Dim>& body, const ContactRun<Dim>& contact, double t,
                          Discretization<Dim> mesh, std::vector<char> fixed) {
  const Discretization<Dim>& old = body.discretization();
  require(mesh.nodes_per_element == old.nodes_per_element, "remesh", "nodes per element of the new mesh",
          mesh.nodes_per_element, std::to_string(old.nodes_per_element).c_str());
  require(static_cast<int>(fixed.size()) == mesh.num_dofs(), "remesh", "number of fixed flags", fixed.size(),
          "one per degree of freedom of the new mesh");
  const Eigen::VectorXd start = boundary_displacement<Dim>(old, body.state_old().displacement, mesh, fixed);
  RemeshedRun<Dim> result = run_on(body, contact, std::move(mesh), std::move(fixed));
  result.report.t = t;
  result.report.before = mesh_state(body, contact);
  TransferredState<Dim> state = transferred(body, *result.workpiece, start, contact.accepted().history.du);
  result.workpiece->set_state(state.workpiece);
  result.report.meshed = deformed_volume(*result.workpiece);
  result.contact->set_state(contact_state_on(contact, *result.contact, start, state.du));
  const bool loaded =
      contact.loads().external.act() || body.user_defined(); // equilibrium is the next step's matter
  const int iterations = loaded ? -1 : settle(*result.workpiece, *result.contact, t, state);
  result.report.settled = iterations >= 0;
  result.report.iterations = std::max(iterations, 0);
  result.report.after = mesh_state(*result.workpiece, *result.contact);
  result.origin = std::move(state.origin);
  return result;
}

template <int Dim> bool remesh_due(const Workpiece<Dim>& body, const StepLoop& loop) {
  if (body.law().small_strain()) return false; // the elements stay what they were
  const double shape = least_shape(body), first = reference_shape(body.discretization());
  if (shape < BAD_SHAPE && shape < WORSE * first) return true;
  return shape < ANY_WORSE * first && loop.control().crawls() &&
         loop.last_rejection().find("inverted element") != std::string::npos;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template RemeshedRun<Dim> run_on<Dim>(const Workpiece<Dim>&, const ContactRun<Dim>&, Discretization<Dim>,  \
                                        std::vector<char>);                                                  \
  template RemeshedRun<Dim> remeshed<Dim>(const Workpiece<Dim>&, const ContactRun<Dim>&, double,             \
                                          Discretization<Dim>, std::vector<char>);                           \
  template bool remesh_due<Dim>(const Workpiece<Dim>&, const StepLoop&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
