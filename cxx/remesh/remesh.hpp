#pragma once
// A run on a new mesh of its deformed workpiece (ALGORITHMS.md 19).
#include "remesh/settle.hpp"
#include "run/stepper.hpp"

namespace burnish {

/// All of a run that depends on its mesh.
template <int Dim> struct RemeshedRun {
  std::shared_ptr<ContactSetup<Dim>> setup;
  std::unique_ptr<ContactRun<Dim>> contact;
  std::unique_ptr<Workpiece<Dim>> workpiece;
  std::vector<int> origin; ///< per point of the new mesh: the nearest one of the old mesh
  Remeshing report;
};

/// Body and contact of a run on another mesh of the same body, undeformed, nothing in contact; origin and report are empty.
/// @param fixed num_dofs flags of the mesh: displacement is given
/// @throws std::invalid_argument as setup_on
template <int Dim>
RemeshedRun<Dim> run_on(const Workpiece<Dim>& body, const ContactRun<Dim>& contact, Discretization<Dim> mesh,
                        std::vector<char> fixed);

/// The accepted state on a new mesh, in equilibrium with the tools where they are. What is handed over stays as it is.
/// @param t     instant of the accepted state [time]
/// @param mesh  of the deformed workpiece, with the labels of the contact
/// @param fixed num_dofs flags of the new mesh: displacement is given
/// @throws std::invalid_argument for another number of nodes per element, and as transferred, setup_on, contact_state_on
template <int Dim>
RemeshedRun<Dim> remeshed(const Workpiece<Dim>& body, const ContactRun<Dim>& contact, double t,
                          Discretization<Dim> mesh, std::vector<char> fixed);

/// Whether the elements are bad: the worst has a shape below 0.3 and below half of that in the reference configuration; or
/// the steps crawl since an element would turn inside out and that shape is below 0.8 of it. @param loop of the run
template <int Dim> bool remesh_due(const Workpiece<Dim>& body, const StepLoop& loop);

} // namespace burnish
