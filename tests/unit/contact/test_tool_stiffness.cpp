// Stiffness of tools by the condensed matrix: held, against differences of forces where the body follows by Newton's method on
// the residual that is written down by hand; driven, against one dense solve of the whole matrix.
#include "contact/tool_stiffness.hpp"
#include "unit/contact/driven_sample.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;

namespace {

/// Coordinates of a sample, some of them under motion.
struct Stiff {
  Driven driven;
  Driven alone; // without formulas: its residual in the rows of coordinates is the contact force
  Stiff(double mu, bool coupled, const std::vector<int>& motion)
      : driven(mu, coupled), alone(mu, coupled, false) {
    for (const int k : motion) driven.contact.prescribed.is_motion[static_cast<std::size_t>(k)] = 1;
  }
  bool moves(int k) const { return driven.contact.prescribed.is_motion[static_cast<std::size_t>(k)]; }
  bool follows(int k) const { return driven.contact.model.coupling_of(k); }

  Eigen::MatrixXd held() {
    const Eigen::VectorXd R = driven.spring.force(driven.u);
    ToolStiffness<2> stiffness(driven.contact.model, driven.spring.body);
    return stiffness.held({driven.spring.tangent(driven.u), driven.contact.state, driven.u, R});
  }
  Eigen::MatrixXd computed() {
    return driven_stiffness(driven.contact.model, held(), driven.contact.prescribed, driven.contact.state.q);
  }
  bool inner(Eigen::Index i, int l, bool all_held) const {
    const Unknown kind = driven.kinds()[static_cast<std::size_t>(i)];
    return kind == Unknown::FREE || kind == Unknown::SLIP ||
           (kind == Unknown::COORDINATE && i != 24 + l && !all_held);
  }
  std::vector<Eigen::Index> free_with(int l, bool all_held) const {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < 30; ++i)
      if (inner(i, l, all_held)) free.push_back(i);
    return free;
  }
  /// The matrix with every coordinate unknown, of the residual with or without the drives.
  static Eigen::MatrixXd whole(Driven sample) {
    std::fill(sample.contact.prescribed.is_motion.begin(), sample.contact.prescribed.is_motion.end(), 0);
    return sample.tangent();
  }
  /// Change of all contact forces where coordinate l has moved by h and the body has followed.
  Eigen::VectorXd forces(int l, double h) const {
    const std::vector<Eigen::Index> free = free_with(l, true);
    const Eigen::VectorXd start = driven.residual(Eigen::VectorXd::Zero(30));
    const Eigen::MatrixXd J = whole(driven);
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(J(free, free));
    Eigen::VectorXd z = h * Eigen::VectorXd::Unit(30, 24 + l);
    for (int i = 0; i < 40; ++i) {
      const Eigen::VectorXd r = driven.residual(z) - start;
      z(free) -= lu.solve(Eigen::VectorXd(r(free)));
    }
    return (alone.residual(z) - alone.residual(Eigen::VectorXd::Zero(30))).tail(6);
  }
  /// The same per unit of h by one dense solve, what is under force giving way, too.
  Eigen::VectorXd solved(int l) const {
    const std::vector<Eigen::Index> free = free_with(l, false);
    const Eigen::MatrixXd J = whole(driven);
    Eigen::VectorXd z = Eigen::VectorXd::Unit(30, 24 + l);
    z(free) = -J(free, free).partialPivLu().solve(Eigen::VectorXd(J(free, 24 + l)));
    return (whole(alone) * z).tail(6);
  }
  void expect_column(const Eigen::MatrixXd& stiffness, int l, const Eigen::VectorXd& expected,
                     double tolerance) const {
    for (int k = 0; k < 6; ++k)
      if (!follows(k)) {
        EXPECT_NEAR(stiffness(k, l), expected[k], tolerance * expected.norm()) << k << " by " << l;
      }
  }
};

} // namespace

TEST(ToolStiffness, HeldAgainstFiniteDifferences) {
  for (const double mu : {0., 0.3})
    for (const bool coupled : {false, true}) {
      SCOPED_TRACE(testing::Message() << "mu " << mu << ", coupled " << coupled);
      Stiff stiff(mu, coupled, {});
      const Eigen::MatrixXd S = stiff.held();
      for (int l = 0; l < 6; ++l)
        if (!stiff.follows(l))
          stiff.expect_column(S, l, finite_difference([&](double h) { return stiff.forces(l, h); }, 0, 1e-3),
                              1e-7);
      if (mu == 0) {
        EXPECT_LE((S - S.transpose()).norm(), 1e-12 * S.norm());
      } else {
        EXPECT_GE((S - S.transpose()).norm(), 1e-2 * S.norm());
      }
    }
}

TEST(ToolStiffness, DrivenByOneDenseSolve) {
  for (const double mu : {0., 0.3})
    for (const bool coupled : {false, true})
      for (const bool some : {false, true}) {
        SCOPED_TRACE(testing::Message() << "mu " << mu << ", coupled " << coupled << ", motion " << some);
        const std::vector<int> motion = coupled ? std::vector<int>{THETA} : std::vector<int>{THETA, Y, ANGLE};
        Stiff stiff(mu, coupled, some ? motion : std::vector<int>{});
        const Eigen::MatrixXd D = stiff.computed();
        for (int l = 0; l < 6; ++l)
          if (!stiff.follows(l)) stiff.expect_column(D, l, stiff.solved(l), 1e-9);
      }
}

// What is held matters: the comparison above would notice.
TEST(ToolStiffness, FreeCoordinatesGiveWay) {
  Stiff stiff(0.3, false, {THETA, Y, ANGLE});
  const Eigen::MatrixXd held = stiff.held(), driven = stiff.computed();
  EXPECT_GE(std::abs(driven(THETA, THETA) - held(THETA, THETA)), 1e-2 * std::abs(held(THETA, THETA)));
  Stiff all(0.3, false, {R_, PHI, THETA, X, Y, ANGLE});
  EXPECT_LE((all.computed() - all.held()).norm(), 1e-14 * held.norm());
}

// A number does not change; a formula does, by its slope.
TEST(ToolStiffness, ForcesOfFreeCoordinates) {
  Stiff stiff(0.3, false, {THETA, Y, ANGLE});
  stiff.driven.contact.prescribed.formula.clear();
  const Eigen::MatrixXd numbers = stiff.computed();
  for (const int k : {R_, PHI, X}) EXPECT_EQ(numbers(k, THETA), 0);
  EXPECT_NE(numbers(THETA, THETA), 0);
}

// A tool without contact, and a body that nothing but sliding contact holds.
TEST(ToolStiffness, NothingResists) {
  Stiff stiff(0.3, false, {THETA});
  for (ContactNode<2>& node : stiff.driven.contact.state.nodes)
    if (node.tool == 1) make_free(node);
  const Eigen::MatrixXd held = stiff.held(), driven = stiff.computed();
  EXPECT_EQ(held.bottomRows(3).norm() + held.rightCols(3).norm(), 0);
  EXPECT_LE(driven.rightCols(3).norm(), 1e-14) << "what the spring of x yields";
  EXPECT_GE(std::abs(driven(THETA, THETA)), 1e-3);
  EXPECT_TRUE(driven.allFinite());
}

TEST(ToolStiffness, LimitLoad) {
  Stiff stiff(0, false, {THETA, X, Y, ANGLE});
  stiff.driven.contact.prescribed.formula.clear();
  Eigen::MatrixXd S = Eigen::MatrixXd::Identity(6, 6);
  S(R_, R_) = S(R_, PHI) = S(PHI, R_) = S(PHI, PHI) = 2; // one way of r and phi meets no resistance
  const auto of = [&](const Eigen::MatrixXd& held) {
    return driven_stiffness(stiff.driven.contact.model, held, stiff.driven.contact.prescribed,
                            stiff.driven.contact.state.q);
  };
  EXPECT_TRUE(std::isnan(of(S)(THETA, THETA)));
  EXPECT_NEAR(of(S)(R_, R_), 0, 1e-15) << "moved itself, the other follows";
  S(PHI, PHI) = 3;
  EXPECT_NEAR(of(S)(THETA, THETA), 1, 1e-14);
  EXPECT_NEAR(of(S)(R_, R_), 2 - 4. / 3, 1e-14);
}
