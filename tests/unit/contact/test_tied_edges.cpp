// Tied edges: the condensed tangent against finite differences of the shared rows, symmetry without friction, ties that are
// made before a step and only dropped within it.
#include "contact/tied_edges.hpp"
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Two edges, body nodes (1, 0, 2) and (10, 11, 9) with the mid nodes in the middle, and node 5 alone, on a circle.
struct TiedSample {
  enum { A, MID, B, ALONE, C, MID2, D };
  SpringBody spring{0.3};
  SpringContact contact;
  Eigen::VectorXd u;

  explicit TiedSample(double mu, double first = 1, double second = -1) {
    contact.add(make_tool("tool", Shape::CIRCLE, Frame::POLAR), mu);
    ContactModel<2>& model = contact.model;
    model.candidates = {1, 0, 2, 5, 10, 11, 9};
    model.edge_ends.assign(7, {-1, -1});
    model.edge_ends[MID] = {A, B};
    model.edge_ends[MID2] = {C, D};
    contact.state.nodes.assign(7, {});
    const double sign = mu > 0 ? 1 : 0;
    contact.touch(A, 0, 0.3, sign * first, true); // one end slides, one sticks
    contact.touch(MID, 0, 0.45, 0, false);
    contact.touch(B, 0, 0.6, 0, false);
    contact.touch(ALONE, 0, 0.9, sign, true);
    contact.touch(C, 0, 1.2, sign * first, true); // both slide
    contact.touch(MID2, 0, 1.5, 0, false);
    contact.touch(D, 0, 1.7, sign * second, true);
    for (int i = 0; i < 7; ++i) contact.state.nodes[i].tributary_area = 0.4 + 0.1 * i;
    for (const int middle : {MID, MID2}) contact.state.nodes[middle].tied = true;
    follow_ends(model, contact.state);
    u = 0.2 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().sin();
    contact.place(spring.body, u);
  }
  ContactNode<2>& node(int i) { return contact.state.nodes[i]; }
  Eigen::MatrixXd tangent(bool half = false, FrictionTangent friction = FrictionTangent::CONSISTENT) {
    Condensation<2> condensation(contact.model, spring.body);
    return dense(condensation.condense({spring.tangent(u), contact.state, contact.prescribed,
                                        contact.prescribed, u, spring.force(u), GeometricTerms::COMPLETE,
                                        RightHandSide::TOTAL, half, friction}));
  }
  std::vector<Unknown> kinds() const {
    auto kind = unknowns(contact.model, contact.state, contact.prescribed, spring.body);
    for (const int middle : {MID, MID2}) kind[2 * contact.model.candidates[middle]] = Unknown::GIVEN;
    return kind;
  }
  /// Residual after a change z of the unknowns: mid nodes follow, their forces go to the ends, half each.
  Eigen::VectorXd residual(const Eigen::VectorXd& z) const {
    const ContactModel<2>& model = contact.model;
    ContactState<2> state = contact.state;
    Eigen::VectorXd x = u;
    moved(model, spring.body, z, state, x);
    const auto poses = model.poses(state.q);
    const Tool<2>& tool = *model.tools[0];
    for (const int middle : {MID, MID2}) {
      double slip = 0;
      for (const int end : model.edge_ends[middle]) slip += 0.5 * z[2 * model.candidates[end]];
      ContactNode<2>& mid = state.nodes[middle];
      mid.place = tool.surface().moved(contact.state.nodes[middle].place, Param<2>(slip));
      const int dof = 2 * model.candidates[middle];
      x.segment<2>(dof) = tool.position(poses[0], mid.place) - spring.body.X.segment<2>(dof);
    }
    const Eigen::VectorXd R = spring.force(x);
    Eigen::VectorXd r = Eigen::VectorXd::Zero(z.size());
    r.head(24) = R;
    Eigen::VectorXd N(7), T(7), area(7);
    for (int i = 0; i < 7; ++i) {
      const ContactPoint<2> at = contact_point(model, poses, state.nodes[i]);
      const Vector<2> F = R.segment<2>(2 * model.candidates[i]);
      N[i] = F.dot(at.surface.n);
      T[i] = F.dot(Vector<2>(at.surface.E));
      area[i] = state.nodes[i].tributary_area;
      r.tail(state.q.size()) += at.surface.x_q.transpose() * F;
    }
    for (int i = 0; i < 7; ++i) {
      double n = N[i], t = T[i], a = area[i];
      for (const int middle : {MID, MID2})
        for (const int end : model.edge_ends[middle])
          if (end == i) {
            n += 0.5 * N[middle];
            t += 0.5 * T[middle];
            a += 0.5 * area[middle];
          }
      const double m = contact_point(model, poses, state.nodes[i]).m[0];
      const double limit = model.laws[0].friction().limit(n, a);
      r.segment<2>(2 * model.candidates[i]) = Vector<2>(t + m * limit, 0);
    }
    return r;
  }
  Eigen::MatrixXd expected() const {
    return differenced([&](const Eigen::VectorXd& change) { return residual(change); }, kinds(), 2e-3);
  }
};

} // namespace

// A mid node between an end that slides and one that sticks, and one between two that slide, the same way or against one
// another; Coulomb's law and one that is not linear in N.
TEST(TiedEdges, TangentAgainstFiniteDifferences) {
  for (const double second : {1., -1.})
    for (const bool limited : {false, true}) {
      SCOPED_TRACE(second);
      TiedSample s(0.3, 1, second);
      if (limited) s.contact.model.laws = {TangentialLaw<2>(make_limited_coulomb(0.3, 0.5))};
      expect_blocks(s.tangent(), s.expected(), s.kinds(), 1e-9);
    }
}

TEST(TiedEdges, SymmetricWithoutFriction) {
  TiedSample s(0);
  const Eigen::MatrixXd K = s.tangent();
  EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm());
  EXPECT_LE((K - s.tangent(true)).norm(), 1e-14 * K.norm()) << "the lower triangle stands for both";
  TiedSample rough(0.3);
  const Eigen::MatrixXd k = rough.tangent();
  EXPECT_GE((k - k.transpose()).norm(), 1e-2 * k.norm());
  const Eigen::MatrixXd S = rough.tangent(false, FrictionTangent::LAGGED);
  EXPECT_LE((S - S.transpose()).norm(), 1e-14 * S.norm());
  EXPECT_LE((S - rough.tangent(true, FrictionTangent::LAGGED)).norm(), 1e-14 * S.norm());
}

TEST(TiedEdges, MadeWhereAnEndSticks) {
  TiedSample s(0.3);
  tie_edges(s.contact.model, s.contact.state.nodes, s.contact.state);
  EXPECT_TRUE(s.node(s.MID).tied);
  EXPECT_FALSE(s.node(s.MID2).tied) << "both ends slide";
  EXPECT_FALSE(s.node(s.A).tied || s.node(s.B).tied || s.node(s.ALONE).tied);
  s.node(s.B).tool = 1;
  tie_edges(s.contact.model, s.contact.state.nodes, s.contact.state);
  EXPECT_FALSE(s.node(s.MID).tied) << "another tool";
  s.node(s.B).tool = 0;
  s.contact.model.laws = {TangentialLaw<2>(std::make_shared<StickingFriction>())};
  tie_edges(s.contact.model, s.contact.state.nodes, s.contact.state);
  EXPECT_FALSE(s.node(s.MID).tied) << "a law without slip";
}

// Between events a tie outlives the stick of its ends, and begins only where the forces do not jump.
TEST(TiedEdges, KeptBetweenEvents) {
  TiedSample s(0.3);
  const auto keep = [&] { keep_ties(s.contact.model, s.contact.state); };
  const auto untie = [&] {
    for (auto& node : s.contact.state.nodes) node.tied = false;
  };
  keep();
  EXPECT_TRUE(s.node(s.MID).tied && s.node(s.MID2).tied) << "both ends of the second slide";
  untie();
  keep();
  EXPECT_TRUE(s.node(s.MID).tied) << "it slides as its sliding end does";
  EXPECT_FALSE(s.node(s.MID2).tied) << "no end sticks";
  untie();
  make_slide(s.node(s.MID), Vector<2>(-s.node(s.A).slip_direction));
  keep();
  EXPECT_FALSE(s.node(s.MID).tied) << "it slides against its end";
  make_stick(s.node(s.MID));
  keep();
  EXPECT_FALSE(s.node(s.MID).tied) << "it sticks, an end slides";
  make_stick(s.node(s.A));
  keep();
  EXPECT_TRUE(s.node(s.MID).tied) << "all three stick";
  make_free(s.node(s.B));
  keep();
  EXPECT_FALSE(s.node(s.MID).tied);
}

// Half of the slips of both ends, and their states.
TEST(TiedEdges, MidNodeFollowsItsEnds) {
  TiedSample s(0.3);
  const Surface<2>& surface = s.contact.model.tools[0]->surface();
  s.node(s.A).place = surface.moved(s.node(s.A).slip_origin, Param<2>(0.02));
  s.node(s.C).place = surface.moved(s.node(s.C).slip_origin, Param<2>(0.02));
  s.node(s.D).place = surface.moved(s.node(s.D).slip_origin, Param<2>(-0.06));
  follow_ends(s.contact.model, s.contact.state);
  EXPECT_EQ(s.node(s.MID).state, NodeState::SLIDING);
  EXPECT_NEAR(slip_of(s.contact.model, s.node(s.MID), 1)[0], 0.01, 1e-14);
  EXPECT_NEAR(slip_of(s.contact.model, s.node(s.MID2), 1)[0], -0.02, 1e-14);
  make_stick(s.node(s.A));
  follow_ends(s.contact.model, s.contact.state);
  EXPECT_EQ(s.node(s.MID).state, NodeState::STICKING);
  EXPECT_EQ(slip_of(s.contact.model, s.node(s.MID), 1)[0], 0);
}

TEST(TiedEdges, DroppedTieDoesNotReturn) {
  for (const int which : {TiedSample::A, TiedSample::B, TiedSample::MID}) {
    TiedSample s(0.3);
    const ContactNode<2> before = s.node(which);
    make_free(s.node(which));
    follow_ends(s.contact.model, s.contact.state);
    EXPECT_FALSE(s.node(s.MID).tied);
    s.node(which) = before;
    s.node(which).tied = false;
    follow_ends(s.contact.model, s.contact.state);
    EXPECT_FALSE(s.node(s.MID).tied) << "in the same step";
    EXPECT_TRUE(s.node(s.MID2).tied);
  }
}

TEST(TiedEdges, ForcesGoToTheEnds) {
  TiedSample s(0.3);
  std::vector<SurfaceForce<2>> own(7);
  for (int i = 0; i < 7; ++i) own[i] = {1. + i, Param<2>(0.1 * i)};
  auto deciding =
      deciding_forces(s.contact.model, s.contact.state, s.contact.model.poses(s.contact.state.q), own);
  EXPECT_DOUBLE_EQ(deciding[s.A].force.N, 1 + 0.5 * 2);
  EXPECT_DOUBLE_EQ(deciding[s.B].force.T[0], 0.2 + 0.5 * 0.1);
  EXPECT_DOUBLE_EQ(deciding[s.D].area, 1.0 + 0.5 * 0.9);
  EXPECT_DOUBLE_EQ(deciding[s.ALONE].force.N, 4);
  EXPECT_DOUBLE_EQ(deciding[s.MID].force.N, 2) << "its own: it may be released";
  s.node(s.MID).tied = false;
  deciding = deciding_forces(s.contact.model, s.contact.state, s.contact.model.poses(s.contact.state.q), own);
  EXPECT_DOUBLE_EQ(deciding[s.A].force.N, 1);
}
