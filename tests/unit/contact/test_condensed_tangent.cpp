// T1: the condensed tangent with COMPLETE terms against finite differences of the condensed residual, block
// by block, and what the ARTICLE and NONE forms leave out.
#include "contact/formula_friction.hpp"
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"
#include <tuple>

using namespace burnish;
using namespace burnish::test;

namespace {

struct Sample {
  SpringBody spring{0.3};
  SpringContact contact;
  Eigen::VectorXd u;
  Eigen::MatrixXd tangent(GeometricTerms terms, bool half = false) {
    Condensation<2> condensation(contact.model, spring.body);
    return dense(
        condensation.condense({spring.tangent(u), contact.state, contact.prescribed, contact.prescribed, u,
                               spring.force(u), terms, RightHandSide::TOTAL, half}));
  }
  std::vector<Unknown> kinds() const {
    return unknowns(contact.model, contact.state, contact.prescribed, spring.body);
  }
  Eigen::MatrixXd expected(double step = 2e-3) const {
    const auto force = [this](const Eigen::VectorXd& x) { return spring.force(x); };
    return differenced(contact.model, spring.body, force, contact.state, u, kinds(), step);
  }
};

/// Nodes in contact and fixed dofs: slides along +s, sticks, slides along -s, free, sticks, slides along +s.
Sample sample(Shape shape, Frame frame, double mu, bool may_slide = true, bool may_stick = true) {
  Sample result;
  result.contact.add(make_tool("tool", shape, frame), mu);
  result.spring.body.fixed[0] = result.spring.body.fixed[23] = 1;
  const double sign = mu > 0 ? 1 : 0;
  if (may_slide) {
    result.contact.touch(0, 0, 0.3, sign, true);
    result.contact.touch(2, 0, 0.9, -sign, true);
    result.contact.touch(5, 0, 1.7, sign, true);
  }
  if (may_stick) {
    result.contact.touch(1, 0, 0.55, 0, false);
    result.contact.touch(4, 0, 1.4, 0, false);
  }
  result.u = 0.2 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().sin();
  result.contact.place(result.spring.body, result.u);
  return result;
}

class CondensedTangent : public testing::TestWithParam<std::tuple<Shape, Frame, double>> {};

std::string name_of_case(const testing::TestParamInfo<CondensedTangent::ParamType>& info) {
  const char* shapes[] = {"Circle", "InsideCircle", "Segment", "ArcChain", "Spline"};
  const char* frames[] = {"Cartesian", "Polar", "Crank", "PolarByFormula", "Growing"};
  return std::string(shapes[static_cast<int>(std::get<0>(info.param))]) +
         frames[static_cast<int>(std::get<1>(info.param))] +
         (std::get<2>(info.param) > 0 ? "Friction" : "NoFriction");
}

} // namespace

TEST_P(CondensedTangent, EveryBlockAgainstFiniteDifferences) {
  const auto [shape, frame, mu] = GetParam();
  Sample mixed = sample(shape, frame, mu), slip = sample(shape, frame, mu, true, false),
         stick = sample(shape, frame, mu, false, true);
  expect_blocks(mixed.tangent(GeometricTerms::COMPLETE), mixed.expected(), mixed.kinds(), 1e-9);
  expect_blocks(slip.tangent(GeometricTerms::COMPLETE), slip.expected(), slip.kinds(), 1e-9);
  expect_blocks(stick.tangent(GeometricTerms::COMPLETE), stick.expected(), stick.kinds(), 1e-9);
}

// The tangent without its geometric terms must fail this test by far, or the test shows nothing.
TEST_P(CondensedTangent, GeometricTermsMatter) {
  const auto [shape, frame, mu] = GetParam();
  Sample mixed = sample(shape, frame, mu);
  const Eigen::MatrixXd expected = mixed.expected(), none = mixed.tangent(GeometricTerms::NONE);
  const auto error = [&](Unknown a, Unknown b) { return block_error(none, expected, mixed.kinds(), a, b); };
  EXPECT_LE(error(Unknown::FREE, Unknown::COORDINATE), 1e-9);
  EXPECT_LE(error(Unknown::COORDINATE, Unknown::FREE), 1e-9);
  if (shape != Shape::SEGMENT) {
    EXPECT_GE(error(Unknown::SLIP, Unknown::SLIP), 1e-3);
  }
  EXPECT_GE(error(Unknown::SLIP, Unknown::COORDINATE), 1e-3);
  EXPECT_GE(error(Unknown::COORDINATE, Unknown::SLIP), 1e-3);
  EXPECT_GE(error(Unknown::COORDINATE, Unknown::COORDINATE), 1e-3);
}

TEST_P(CondensedTangent, SymmetricWithoutFriction) {
  const auto [shape, frame, mu] = GetParam();
  Sample mixed = sample(shape, frame, mu);
  const Eigen::MatrixXd K = mixed.tangent(GeometricTerms::COMPLETE);
  const double asymmetry = (K - K.transpose()).norm() / K.norm();
  if (mu > 0 || frame == Frame::GROWING) { // of one that grows where T = 0 holds, METHOD.md 3.2
    EXPECT_GE(asymmetry, 1e-2);
    return;
  }
  EXPECT_LE(asymmetry, 1e-14);
  const Eigen::MatrixXd half = mixed.tangent(GeometricTerms::COMPLETE, true);
  EXPECT_LE((K - half).norm(), 1e-14 * K.norm()) << "the lower triangle stands for both";
}

// ARTICLE: the (s,s) and (s,q) parts only; NONE: no part.
TEST_P(CondensedTangent, ShorterFormsDifferByTheirParts) {
  const auto [shape, frame, mu] = GetParam();
  Sample mixed = sample(shape, frame, mu);
  const Eigen::Index nq = mixed.contact.model.num_coordinates();
  const Eigen::MatrixXd complete = mixed.tangent(GeometricTerms::COMPLETE),
                        article = mixed.tangent(GeometricTerms::ARTICLE),
                        none = mixed.tangent(GeometricTerms::NONE);
  const Eigen::VectorXd R = mixed.spring.force(mixed.u);
  Eigen::MatrixXd slip_rows = Eigen::MatrixXd::Zero(complete.rows(), complete.cols()), rest = slip_rows;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& node = mixed.contact.state.nodes[i];
    if (!in_contact(node.state)) continue;
    const int dof = 2 * mixed.contact.model.candidates[i];
    const auto poses = mixed.contact.model.poses(mixed.contact.state.q);
    const auto linear = linearize_node<2>(mixed.contact.model, node, static_cast<int>(i), poses,
                                          R.segment<2>(dof), GeometricTerms::COMPLETE);
    rest.block(24, 24, nq, nq) += linear.geo_qq;
    if (!linear.sliding) continue;
    slip_rows(dof, dof) += linear.geo_ss(0, 0);
    slip_rows.block(dof, 24, 1, nq) += linear.geo_sq;
    rest.block(24, dof, nq, 1) += linear.geo_qs.transpose();
  }
  EXPECT_LE((none + slip_rows - article).norm(), 1e-14 * complete.norm());
  EXPECT_LE((none + slip_rows + rest - complete).norm(), 1e-14 * complete.norm());
  EXPECT_GE(rest.norm(), 1e-3 * complete.norm());
  EXPECT_GE(slip_rows.norm(), 1e-3 * complete.norm());
}

INSTANTIATE_TEST_SUITE_P(T1, CondensedTangent,
                         testing::Combine(testing::Values(Shape::CIRCLE, Shape::INSIDE, Shape::SEGMENT,
                                                          Shape::ARC_CHAIN, Shape::SPLINE),
                                          testing::Values(Frame::CARTESIAN, Frame::POLAR, Frame::CRANK,
                                                          Frame::POLAR_BY_FORMULA, Frame::GROWING),
                                          testing::Values(0., 0.3)),
                         name_of_case);

namespace {

// Every node slides the same way, so that each sign stands alone.
void check_one_sign(double sign) {
  Sample s = sample(Shape::CIRCLE, Frame::POLAR, 0.3, false, false);
  s.contact.touch(1, 0, 0.55, sign, true);
  s.contact.touch(3, 0, 1.1, sign, true);
  s.contact.place(s.spring.body, s.u);
  expect_blocks(s.tangent(GeometricTerms::COMPLETE), s.expected(), s.kinds(), 1e-9);
}

} // namespace

TEST(CondensedTangentMore, EitherSlipSign) {
  check_one_sign(1);
  check_one_sign(-1);
}

// Two tools with different coordinates and friction; neighboring nodes belong to different tools.
TEST(CondensedTangentMore, TwoTools) {
  Sample s;
  s.contact.add(make_tool("circle", Shape::CIRCLE, Frame::POLAR), 0.2);
  s.contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), 0);
  s.contact.touch(0, 0, 0.2, 1, true);
  s.contact.touch(1, 1, 0.6, 0, true);
  s.contact.touch(2, 0, 0.8, 0, false);
  s.contact.touch(3, 1, 1.9, 0, true);
  s.contact.touch(4, 0, 1.9, -1, true);
  s.contact.prescribed.is_motion[1] = s.contact.prescribed.is_motion[5] = 1;
  s.u = 0.2 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().cos();
  s.contact.place(s.spring.body, s.u);
  expect_blocks(s.tangent(GeometricTerms::COMPLETE), s.expected(), s.kinds(), 1e-9);
}

// Laws of pressure and traction, every node with a tributary area of its own; the limited one on both sides of its kink.
TEST(CondensedTangentMore, EveryFrictionLaw) {
  struct Case {
    const char* name;
    std::shared_ptr<const FrictionLaw> law;
    int steep; // of the three sliding nodes, those where g grows with N
  };
  for (const Case& c : {Case{"Tresca", make_tresca(0.7), 0},
                        {"limited", make_limited_coulomb(0.3, 0.5), 1},
                        {"formula", make_formula_friction("0.1 + mu*p/(1 + (p/3)^2)", {{"mu", 0.3}}), 1}}) {
    SCOPED_TRACE(c.name);
    Sample s = sample(Shape::CIRCLE, Frame::POLAR, 0.3);
    s.contact.model.laws = {TangentialLaw<2>(c.law)};
    const Eigen::VectorXd R = s.spring.force(s.u);
    int steep = 0;
    for (std::size_t i = 0; i < s.contact.state.nodes.size(); ++i) {
      auto& node = s.contact.state.nodes[i];
      node.tributary_area = 0.4 + 0.3 * static_cast<double>(i);
      if (node.state != NodeState::SLIDING) continue;
      const auto p = s.contact.model.tools[0]->point(s.contact.state.q, node.place);
      steep +=
          c.law->slope(R.segment<2>(2 * s.contact.model.candidates[i]).dot(p.n), node.tributary_area) > 0;
    }
    EXPECT_EQ(steep, c.steep);
    expect_blocks(s.tangent(GeometricTerms::COMPLETE), s.expected(), s.kinds(), 1e-9);
  }
}
