#pragma once
// A body on a circle and a line with forces by formula and coordinates that follow others, and its residual by hand.
#include "contact/coupling.hpp"
#include "contact/driving_force.hpp"
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"

namespace burnish::test {

// q = r, phi, theta of the circle; x, y, angle of the line.
enum { R_, PHI, THETA, X, Y, ANGLE };

/// Five nodes on a circle and a line; y and angle of the line follow r and theta of the circle.
struct Driven {
  SpringBody spring{0.3};
  SpringContact contact;
  Eigen::VectorXd u = 0.2 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().cos();

  explicit Driven(double mu, bool coupled = true, bool formulas = true) {
    contact.add(make_tool("circle", Shape::CIRCLE, Frame::POLAR), mu);
    contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), mu / 2);
    const double sign = mu > 0 ? 1 : 0;
    contact.touch(0, 0, 0.2, sign, true);
    contact.touch(1, 1, 0.6, -sign, true);
    contact.touch(2, 0, 0.8, 0, false);
    contact.touch(3, 1, 1.9, 0, false);
    contact.touch(4, 0, 1.9, -sign, true);
    if (coupled) {
      contact.model.couplings.push_back(
          make_coupling(contact.model, "line.y", "0.3*sin(2*circle.r)*circle.theta - 0.7"));
      contact.model.couplings.push_back(make_coupling(contact.model, "line.angle", "-2*circle.theta"));
    }
    follow(contact.model, contact.state.q);
    if (formulas) add_formulas();
    contact.prescribed.t = 0.7;
    contact.place(spring.body, u);
  }
  void add_formulas() {
    const std::vector<std::string> polar = contact.model.tools[0]->coordinates().names(),
                                   cartesian = contact.model.tools[1]->coordinates().names();
    auto& formula = contact.prescribed.formula;
    formula.resize(6);
    formula[R_] = force_formula("circle", "r", "-k*r^3 + phi*theta - t", polar, {{"k", 4}});
    formula[PHI] = force_formula("circle", "phi", "-2*phi + r*theta - r", polar, {});
    formula[X] = force_formula("line", "x", "-3*x*y - abs(x)", cartesian, {});
  }
  bool coupled() const { return !contact.model.couplings.empty(); }
  /// The residual with forces and relations put in by hand.
  Eigen::VectorXd residual(const Eigen::VectorXd& z) const {
    ContactState<2> state = contact.state;
    Eigen::VectorXd q = state.q + z.tail(6), change = z;
    if (coupled()) {
      q[Y] = 0.3 * std::sin(2 * q[R_]) * q[THETA] - 0.7;
      q[ANGLE] = -2 * q[THETA];
      change.tail(6) = q - state.q;
    }
    const auto force = [this](const Eigen::VectorXd& x) { return spring.force(x); };
    Eigen::VectorXd r = condensed_residual(contact.model, spring.body, force, change, state, u);
    auto Q = r.tail(6);
    if (coupled()) {
      Q[R_] += 0.6 * std::cos(2 * q[R_]) * q[THETA] * Q[Y];
      Q[THETA] += 0.3 * std::sin(2 * q[R_]) * Q[Y] - 2 * Q[ANGLE];
      Q[Y] = Q[ANGLE] = 0;
    }
    if (contact.prescribed.formula.empty()) return r;
    Q[R_] -= -4 * std::pow(q[R_], 3) + q[PHI] * q[THETA] - 0.7;
    Q[PHI] -= -2 * q[PHI] + q[R_] * q[THETA] - q[R_];
    Q[X] -= -3 * q[X] * q[Y] - std::abs(q[X]);
    return r;
  }
  std::vector<Unknown> kinds() const {
    auto kind = unknowns(contact.model, contact.state, contact.prescribed, spring.body);
    if (coupled()) kind[24 + Y] = kind[24 + ANGLE] = Unknown::GIVEN;
    return kind;
  }
  Eigen::MatrixXd expected() const {
    return differenced([&](const Eigen::VectorXd& change) { return residual(change); }, kinds(), 2e-3);
  }
  CondensedSystem system(Condensation<2>& condensation, bool half = false) {
    return condensation.condense({spring.tangent(u), contact.state, contact.prescribed, contact.prescribed, u,
                                  spring.force(u), GeometricTerms::COMPLETE, RightHandSide::TOTAL, half});
  }
  Eigen::MatrixXd tangent(bool half = false) {
    Condensation<2> condensation(contact.model, spring.body);
    return dense(system(condensation, half));
  }
};

} // namespace burnish::test
