#pragma once
// Equilibrium on a new mesh while the tools stand still, and how far the new mesh is from the old one (ALGORITHMS.md 19.4).
#include "remesh/state_transfer.hpp"
#include "run/contact_run.hpp"

namespace burnish {

/// What a mesh is to the run: compared before and after.
struct MeshState {
  int nodes = 0;
  double shape = 0;                   ///< of the worst element [-]
  double volume = 0;                  ///< of the body [length^Dim, length^3]
  double elastic_energy = 0;          ///< stored; NaN where the law does not tell [force length]
  std::vector<Eigen::VectorXd> force; ///< of each tool on the body [force]
};
/// Of the accepted state.
template <int Dim> MeshState mesh_state(const Workpiece<Dim>& body, const ContactRun<Dim>& contact);

/// A new mesh of a run.
struct Remeshing {
  double t = 0;
  MeshState before, after;
  int iterations = 0;    ///< to equilibrium on the new mesh
  bool settled = false;  ///< it was found
  double meshed = 0;     ///< volume of the new mesh, before equilibrium [length^Dim, length^3]
  double volume() const; ///< its change over the volume before [-]
  double energy() const; ///< change of the stored energy over that before [-]; 0: not known
  double force() const;  ///< largest change of a tool's force over the largest force before [-]; 0: not known
};

/// Iterates to equilibrium where nothing is driven; where it is not found at once, what is out of balance is let go of in
/// parts. State of body and contact at its end are accepted ones, with the rates of the last step. Where it is not found both are
/// as before.
/// @param t     instant of the accepted state [time]
/// @param start state of the body, which it has
/// @returns number of iterations, < 0: not found
template <int Dim>
int settle(Workpiece<Dim>& body, ContactRun<Dim>& contact, double t, const TransferredState<Dim>& start);

} // namespace burnish
