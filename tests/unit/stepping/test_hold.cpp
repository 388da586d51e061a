// Soft hold: volume of its springs, fading, tangent, state.
#include "stepping/hold.hpp"
#include "support/run.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

struct Held {
  ContactMesh mesh;
  BodyView<2> body;
  Hold<2> hold;
  explicit Held(int order, bool axisymmetric = false)
      : mesh(block_mesh(3, 2, order, 4, 1.5)), hold(mesh.space, body) {
    mesh.space.axisymmetric = axisymmetric;
    body.X = Eigen::Map<const Eigen::VectorXd>(mesh.space.X.data(), mesh.space.num_dofs());
    body.fixed.assign(mesh.space.num_dofs(), 0);
  }
  Eigen::VectorXd moved(double x, double y) const {
    Eigen::VectorXd u(mesh.space.num_dofs());
    for (Eigen::Index d = 0; d < u.size(); d += 2) u.segment<2>(d) = Vector<2>(x, y);
    return u;
  }
  Vector<2> pull(const Eigen::VectorXd& f) const {
    Vector<2> sum(0, 0);
    for (Eigen::Index d = 0; d < f.size(); d += 2) sum += f.segment<2>(d);
    return sum;
  }
};

} // namespace

TEST(Hold, PullsByStiffnessVolumeAndWay) {
  for (const int order : {1, 2})
    for (const bool ring : {false, true}) {
      Held held(order, ring);
      held.hold.set(0.5, 3);
      held.hold.begin(1, held.moved(0.1, 0.2));
      const Vector<2> f = held.pull(held.hold.force(held.moved(0.4, 0), 1));
      const double volume = 4 * 1.5 * (ring ? 2 * M_PI * 2 : 1); // centroid at r = 2
      EXPECT_NEAR(f[0], -0.5 * volume * 0.3, 1e-12);
      EXPECT_NEAR(f[1], 0.5 * volume * 0.2, 1e-12);
    }
}

TEST(Hold, FadesLinearlyFromTheStepInWhichItBegan) {
  Held held(1);
  EXPECT_FALSE(held.hold.acts(0));
  held.hold.set(2, 3);
  EXPECT_FALSE(held.hold.acts(1)); // not begun
  held.hold.begin(1, held.moved(0, 0));
  held.hold.begin(2, held.moved(5, 5)); // it has begun
  EXPECT_DOUBLE_EQ(held.hold.factor(1), 1);
  EXPECT_DOUBLE_EQ(held.hold.factor(2.5), 0.25);
  EXPECT_EQ(held.hold.factor(3), 0);
  EXPECT_EQ(held.hold.factor(3 - 1e-10), 0); // rounding of an instant
  EXPECT_EQ(held.hold.factor(4), 0);
}

TEST(Hold, TangentIsTheDerivativeOfItsForceAndSparesGivenComponents) {
  Held held(2);
  held.body.fixed[3] = 1;
  held.hold.set(2, 3);
  held.hold.begin(0, held.moved(0, 0));
  auto K = pattern_from_elements<2>(held.mesh.space.num_nodes, 6, held.mesh.space.connectivity);
  held.hold.add_stiffness(1.2, K);
  Eigen::VectorXd u(held.mesh.space.num_dofs()), R = Eigen::VectorXd::Zero(u.size());
  for (Eigen::Index d = 0; d < u.size(); ++d) u[d] = std::sin(1. + 3 * d);
  held.hold.add_force(u, 1.2, R);
  EXPECT_LE((K.multiply(u) - R).norm(), 1e-14 * R.norm());
  EXPECT_GT(R.norm(), 0);
  EXPECT_EQ(R[3], 0);
  const Eigen::VectorXd before = R;
  held.hold.add_force(u, 3, R);
  EXPECT_EQ(R, before);
}

TEST(Hold, SaysWhatItStillCarries) {
  Held held(1);
  held.hold.set(2, 3);
  held.hold.begin(0, held.moved(0, 0));
  held.hold.accept(held.moved(1e-4, 0), 2, 10);
  EXPECT_EQ(held.hold.warning(), "");
  held.hold.accept(held.moved(1, 0), 2, 10);
  EXPECT_NEAR(held.hold.state().share, 2. / 3 * 6 * 0.5 * 2 * 0.5 / 5, 1e-12); // 4 of 10
  EXPECT_NE(held.hold.warning().find("the hold, which ends at t = 3, carries 0.4 of the load"),
            std::string::npos)
      << held.hold.warning();
  held.hold.accept(held.moved(1, 0), 3, 10);
  EXPECT_NE(held.hold.warning().find("when the hold ended at t = 3 it still carried 0.4"), std::string::npos);
}

TEST(Hold, RefusesWhatIsNone) {
  Held held(1);
  for (const double stiffness : {0., -1., double(NAN), double(INFINITY)})
    EXPECT_THROW(held.hold.set(stiffness, 1), std::invalid_argument) << stiffness;
  EXPECT_THROW(held.hold.set(1, NAN), std::invalid_argument);
  held.hold.set(1, 2);
  EXPECT_THROW(held.hold.begin(2, held.moved(0, 0)), std::invalid_argument);
}
