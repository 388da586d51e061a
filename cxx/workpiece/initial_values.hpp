#pragma once
// A workpiece that is under stress, or has flowed, before its first step.
#include "workpiece/workpiece.hpp"
#include <string>

namespace burnish {

/// Internal nodal forces of the accepted state.
struct OutOfBalance {
  double unbalanced = 0; ///< largest at a component that no support holds [force]
  double largest = 0;    ///< largest [force]
};
/// @param fixed num_dofs flags: supports
template <int Dim> OutOfBalance out_of_balance(const Workpiece<Dim>& body, const std::vector<char>& fixed);

/// Kirchhoff stress of the undeformed body, in place of zero.
/// @param stress num_stress arrays of one number per point, in the order of Stress [stress]
/// @throws std::invalid_argument "where: ..." after a step, for another size, numbers that are not finite, a stress outside the
///         yield surface (names point and place)
template <int Dim>
void set_initial_stress(Workpiece<Dim>& body, const std::vector<Eigen::VectorXd>& stress, const char* where);

/// A component of an internal variable, in place of its initial value: the plastic strain, or the back stress. Before the
/// stress, which must lie within its yield surface.
/// @param values one per point [its unit]
/// @throws std::invalid_argument "where: ..." after a step, for a wrong name, component or size, numbers that are not finite, a
///         plastic strain < 0
template <int Dim>
void set_initial_variable(Workpiece<Dim>& body, const std::string& name, int component,
                          const Eigen::VectorXd& values, const char* where);

} // namespace burnish
