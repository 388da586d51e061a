// Soft hold: volume of its springs, fading, tangent, state.
#include "run/hold.hpp"
#include "support/run.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

struct Held {
  ContactMesh mesh;
  BodyView<2> body;
  Hold<2> hold;
  static ContactMesh block(int order, bool axisymmetric) {
    ContactMesh mesh = block_mesh(3, 2, order, 4, 1.5);
    mesh.space.axisymmetric = axisymmetric;
    return mesh;
  }
  explicit Held(int order, bool axisymmetric = false)
      : mesh(block(order, axisymmetric)), hold(mesh.space, body) {
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

TEST(NodalSprings, AreAsStiffAsTheMeanDiagonal) {
  Held held(1);
  const NodalSprings<2> springs(held.mesh.space, held.body);
  NodeBlockMatrix<2> K;
  K.num_nodes = held.mesh.space.num_nodes;
  for (int node = 0; node <= K.num_nodes; ++node) K.row_start.push_back(node);
  for (int node = 0; node < K.num_nodes; ++node) K.col.push_back(node);
  K.value.assign(static_cast<std::size_t>(4 * K.num_nodes), 0);
  springs.add_stiffness(0.7, K);
  EXPECT_NEAR(springs.stiffness_of(K), 0.7, 1e-14);
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

// A step ends at the instant at which the hold does; a copy of the run goes on to the same bits through it.
TEST(Hold, OfARunEndsWithAStepAndIsPartOfItsState) {
  const auto scene = [] {
    auto block = std::make_unique<Scene>(block_mesh(12, 4, 2, 4, 1.5), elastic_material());
    block->add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
    block->place({1.7, 4.9, 0});
    block->contact().approach(0, "y", block->u);
    return block;
  };
  const auto program = [](Scene& block) {
    return [&block](double t) {
      block.tool->prescription().move("x", 1.7);
      block.tool->prescription().move("y", 4.5 - 0.05 * t);
      block.tool->prescription().move("angle", 0);
    };
  };
  StepControlOptions control;
  control.dt_max = 0.09;
  const auto one = scene(), other = scene();
  one->contact().loads().hold.set(0.1, 0.61);
  Stepper<2> first(one->contact(), one->body, one->diagnosis, StepControl(0, control), {});
  Stepper<2> second(other->contact(), other->body, other->diagnosis, StepControl(0, control), {});
  while (first.counts().steps < 4) answer(first.next(one->u, one->R), *one, first, program(*one));
  EXPECT_GT(first.state().contact.hold.share, 0);
  second.set_state(first.state(), other->u, other->R);
  bool hit = false;
  ASSERT_EQ(run(*one, first, program(*one), [&] { hit = hit || first.target() == 0.61; }), Task::FINISHED);
  ASSERT_EQ(run(*other, second, program(*other)), Task::FINISHED);
  EXPECT_TRUE(hit);
  EXPECT_EQ(one->u, other->u);
  EXPECT_EQ(one->contact().loads().hold.state().factor, 0);

  const auto without = scene();
  Stepper<2> third(without->contact(), without->body, without->diagnosis, StepControl(0, control), {});
  ASSERT_EQ(run(*without, third, program(*without)), Task::FINISHED);
  const double Q = without->tool->generalized_force()[1];
  EXPECT_NEAR(one->tool->generalized_force()[1], Q, 1e-2 * std::abs(Q)); // by friction the path counts
}

TEST(Hold, RefusesWhatIsNone) {
  Held held(1);
  for (const double stiffness : {0., -1., double(NAN), double(INFINITY)})
    EXPECT_THROW(held.hold.set(stiffness, 1), std::invalid_argument) << stiffness;
  EXPECT_THROW(held.hold.set(1, NAN), std::invalid_argument);
  held.hold.set(1, 2);
  EXPECT_THROW(held.hold.begin(2, held.moved(0, 0)), std::invalid_argument);
}
