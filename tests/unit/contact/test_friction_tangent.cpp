// How friction enters the condensed matrix: the lagged one symmetric to rounding, with the same right-hand side, against
// differences of a residual with frozen friction, the same without friction.
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A roller and a line with nodes that slide, stick and are free; one coordinate of each is under motion.
struct Sample {
  SpringBody spring{0.3};
  SpringContact contact;
  Eigen::VectorXd u = 0.2 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().sin();
  explicit Sample(double mu) {
    contact.add(make_tool("roller", Shape::CIRCLE, Frame::POLAR), mu);
    contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), mu / 2);
    const double sign = mu > 0 ? 1 : 0;
    contact.touch(0, 0, 0.3, sign, true);
    contact.touch(1, 0, 0.55, 0, false);
    contact.touch(2, 0, 0.9, -sign, true);
    contact.touch(4, 1, 0.7, sign, true);
    contact.prescribed.is_motion[1] = contact.prescribed.is_motion[5] = 1;
    contact.prescribed.value << 0.4, contact.state.q[1] + 0.02, -0.3, 0.2, -0.5, contact.state.q[5] - 0.01;
    spring.body.fixed[0] = spring.body.fixed[23] = 1;
    contact.place(spring.body, u);
    u[2 * contact.model.candidates[2]] += 0.01; // an offset
  }
  CondensedSystem condensed(FrictionTangent tangent, bool half = false,
                            RightHandSide right = RightHandSide::TOTAL) {
    Condensation<2> condensation(contact.model, spring.body);
    return condensation.condense({spring.tangent(u), contact.state, contact.prescribed, contact.prescribed, u,
                                  spring.force(u), GeometricTerms::COMPLETE, right, half, tangent});
  }
  /// The friction of every sliding node stays what it is: Tresca's law, k = g(N), unit area.
  Eigen::MatrixXd frozen() const {
    ContactModel<2> model = contact.model;
    ContactState<2> state = contact.state;
    const Eigen::VectorXd R = spring.force(u);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      auto& node = state.nodes[i];
      if (node.state != NodeState::SLIDING) continue;
      const auto p = model.tools[node.tool]->point(model.tool_q(state.q, node.tool), node.place);
      node.tributary_area =
          contact.model.laws[node.tool].friction().limit(R.segment<2>(2 * model.candidates[i]).dot(p.n), 1);
    }
    for (auto& law : model.laws) law = TangentialLaw<2>(make_tresca(1));
    const auto force = [this](const Eigen::VectorXd& x) { return spring.force(x); };
    return differenced(model, spring.body, force, state, u,
                       unknowns(model, state, contact.prescribed, spring.body), 2e-3);
  }
};

double asymmetry(const Eigen::MatrixXd& K) { return (K - K.transpose()).norm() / K.norm(); }

} // namespace

TEST(FrictionTangent, LaggedIsSymmetricToRounding) {
  Sample sample(0.4);
  EXPECT_GE(asymmetry(dense(sample.condensed(FrictionTangent::CONSISTENT))), 1e-2);
  const Eigen::MatrixXd full = dense(sample.condensed(FrictionTangent::LAGGED)),
                        half = dense(sample.condensed(FrictionTangent::LAGGED, true));
  EXPECT_LE(asymmetry(full), 1e-15);
  EXPECT_LE((full - half).norm(), 1e-15 * full.norm()) << "the lower triangle stands for both";
}

// Without the offsets, which W' K o of the right-hand side multiplies, all residuals are the same.
TEST(FrictionTangent, LaggedIsTheDerivativeAtFrozenFriction) {
  Sample sample(0.4);
  sample.contact.place(sample.spring.body, sample.u);
  sample.contact.prescribed.value[1] = sample.contact.state.q[1];
  sample.contact.prescribed.value[5] = sample.contact.state.q[5];
  const CondensedSystem lagged = sample.condensed(FrictionTangent::LAGGED),
                        whole = sample.condensed(FrictionTangent::CONSISTENT);
  const auto kinds =
      unknowns(sample.contact.model, sample.contact.state, sample.contact.prescribed, sample.spring.body);
  expect_blocks(dense(lagged), sample.frozen(), kinds, 1e-9);
  EXPECT_GE((dense(lagged) - dense(whole)).norm(), 1e-2 * dense(whole).norm());
  EXPECT_LE((lagged.rhs - whole.rhs).norm(), 1e-14 * whole.rhs.norm());
}

TEST(FrictionTangent, AllTheSameWithoutFriction) {
  Sample sample(0);
  const CondensedSystem expected = sample.condensed(FrictionTangent::CONSISTENT),
                        found = sample.condensed(FrictionTangent::LAGGED);
  EXPECT_LE((dense(found) - dense(expected)).norm(), 1e-15 * dense(expected).norm());
  EXPECT_EQ((found.rhs - expected.rhs).norm(), 0);
}

TEST(FrictionTangent, WhatIsRefused) {
  Sample sample(0.4);
  expect_invalid([&] { sample.condensed(FrictionTangent::CONSISTENT, true); },
                 "condense: symmetric storage needs a contact without friction");
  expect_invalid([&] { sample.condensed(FrictionTangent::LAGGED, false, RightHandSide::RATES); },
                 "condense: pure rates are solved once and need the consistent tangent of friction");
}
