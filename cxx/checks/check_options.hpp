#pragma once
// Bounds of the self-checks (ALGORITHMS.md 16). All numbers are free of units.

namespace burnish {

struct CheckOptions {
  bool on = true;
  double imbalance = 1e-2;          ///< forces and moments out of balance over the load: untrusted above ...
  double imbalance_tolerances = 20; ///< ... or above so many tolerances of the residual, whichever is more
  double imbalance_noted = 2e-3;    ///< the same: warning above
  double residual = 0.01; ///< what the nodes that nothing holds are left with, sum over the load: warning ...
  double residual_far = 0.1; ///< ... untrusted, both above imbalance_tolerances at least
  double unmet = 5e-3;       ///< what a prescribed force of a tool is missed by, over itself: warning ...
  double unmet_far = 0.05;   ///< ... untrusted, the same
  double unmet_least = 0.05; ///< over this part of the tool's load, if the force is less
  double tension = 0.02;     ///< tension of a tool's nodes over the largest load of the tool: untrusted
  double friction_excess =
      0.02; ///< friction beyond its limit, or along the slip, over the largest load of the tool: untrusted
  double few_edges = 3;    ///< a contact that carries load over so many edges of elements or fewer: warning
  double edge_depth = 0.1; ///< depth of a tool between two contact nodes over their distance: warning ...
  double edge_sunk = 0.5;  ///< ... untrusted
  double overlap = 0.05;   ///< depth of a tool in an edge that it does not touch, over the edge: untrusted
  double tools_overlap = 2e-3; ///< depth of a tool in another one over the smaller one of them: warning
  double pressure_sum =
      0.15; ///< fitted pressures of a tool against its forces, P2: warning; more in few edges
  double yield_distance = 1e-2;  ///< stress beyond the yield surface over the yield stress: warning ...
  double yield_far = 0.1;        ///< ... untrusted
  double energy = 0.1;           ///< error of the energy over the largest work: warning
  double volume = 0.02;          ///< change of volume that is not elastic over the plastic strain: warning
  double plastic_strain = 0.3;   ///< accumulated plastic strain with the Jaumann rate: warning ...
  double plastic_strain_far = 2; ///< ... untrusted
  double determinant = 0.3;     ///< Jacobian of an element over that of the undeformed one: warning below ...
  double determinant_low = 0.1; ///< ... untrusted below
  double quality = 0.1; ///< shape of an element, 1: equilateral: warning below, if it has fallen to a quarter
  double locking = 1;   ///< alternation of the mean stress over the von Mises stress, P1: warning
  int seldom = 10;      ///< checks of fields are made in every so many-th accepted step, and in the last
};

} // namespace burnish
