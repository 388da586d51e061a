#pragma once
// Bounds of the scene report (ALGORITHMS.md 17). All numbers are free of units.

namespace burnish {

struct ReportOptions {
  double plausible_yield = 1e-2; ///< von Mises over yield stress: below, the workpiece is meant to be elastic
  double friction_used = 0.25;   ///< friction over its limit: below, the limit is of no influence
  double loaded = 1e-2;  ///< a node carries load if its normal force is this part of the tool's largest one
  double unmoved = 1e-6; ///< way of a coordinate's points over the size of the body: below, it never moved
  double idle_energy = 1e-3;  ///< energy of half of the mesh over that of all of it: below, it is idle
  double fine_steps = 0.1;    ///< error of the steps over the accuracy asked: below, they are too fine
  double asymmetry = 1e-3;    ///< difference of mirrored displacements over the largest: below, symmetric
  double no_strain = 1e-6;    ///< |F - I|: below everywhere, units may be mixed
  double small_strain = 1e-3; ///< |F - I|: below everywhere, the linear form gives the same
  double stress_error = 0.15; ///< recovered against computed stress, relative: above, the mesh is coarse
  double end_load = 0.01;     ///< load of the last node of an open contact surface over that of the tool
  double all_under = 0.9;     ///< a tool that touches this part of the surface covers it on purpose
  double one_point = 0.05;    ///< largest plastic strain of a point over the largest nodal one, less 1
  double one_stress = 0.25;   ///< the same of the von Mises stress
  double flowing = 1e-4;      ///< plastic strain: above, a point counts in the percentile
  double percentile = 0.99;   ///< of the flowing volume
  int seldom = 10; ///< fields are looked at in the first of every so many accepted steps, and in the last
  int most = 10;   ///< statements
};

} // namespace burnish
