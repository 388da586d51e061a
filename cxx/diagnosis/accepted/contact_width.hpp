#pragma once
// How wide the contact of a tool is where it carries most.
#include "base/archive.hpp"
#include "diagnosis/accepted_step.hpp"

namespace burnish {

constexpr double FEW_EDGES =
    3; // of elements: a contact that carries load over so many or fewer is no contact for a mesh

struct ContactWidth {
  double load = 0; ///< largest of the run [force]
  int nodes = 0;   ///< in the narrowest part of the contact that carries load there
  std::vector<double> place;
  double t = 0;
  long narrow = 0, steps = 0; ///< steps with few nodes, and all with contact
  BURNISH_FIELDS(load, nodes, place, t, narrow, steps)
};

/// Nodes of FEW_EDGES edges.
template <int Dim> double few_nodes(const Mesh<Dim>& mesh);

/// Takes a step. Judged where the tool carries most, and at the end: a run may well begin with one node.
/// @returns whether the tool carries load in it
template <int Dim> bool follow(const AcceptedStep<Dim>& step, int tool, ContactWidth& width);

} // namespace burnish
