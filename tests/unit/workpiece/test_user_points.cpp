// A workpiece with a user-defined law: what is given for the points is what force, tangent, events and state are made of.
#include "material/user_law.hpp"
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/element_events.hpp"
#include "workpiece/point_fields.hpp"
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {

UpdateOptions single() {
  UpdateOptions options;
  options.update = StressUpdate::SINGLE;
  return options;
}
// A body with the core's law, and one of the same mesh whose law is user-defined.
struct Pair {
  Workpiece<2> core, user;
  explicit Pair(int nodes = 6, std::shared_ptr<const MaterialLaw<2>> law = j2_law<2>(example_material()))
      : core(patch(nodes, 1), j2_law<2>(example_material()), single()), user(patch(nodes, 1), law, single()) {
    user.set_user_defined(true);
  }
  void move(double size) {
    const Eigen::VectorXd u = bent(core.discretization(), 1, size);
    ASSERT_EQ(core.update(u, 1, 0).status, UpdateStatus::OK);
    ASSERT_EQ(user.update(u, 1, 0).status, UpdateStatus::OK);
  }
  Eigen::VectorXd stress(int component) const {
    const int points = core.discretization().num_points();
    Eigen::VectorXd v(points);
    for (int p = 0; p < points; ++p) v[p] = stress_at(core.state(), p)[component];
    return v;
  }
  void give_stress() {
    for (int c = 0; c < 4; ++c) user.given("give").stress(c, stress(c));
    user.given("give").internal("plastic_strain_eq", 0, internal_field(core, "plastic_strain_eq"));
  }
  Eigen::VectorXd field(const std::vector<double>& all, int component, int size) const {
    Eigen::VectorXd v(core.discretization().num_points());
    for (Eigen::Index p = 0; p < v.size(); ++p) v[p] = all[p * size + component];
    return v;
  }
  void give_moduli(int from_row = 0) {
    const std::vector<double> A = moduli_field(core, TangentKind::CONSISTENT);
    for (int i = 0; i < 4; ++i)
      for (int j = from_row > 0 ? 0 : i; j < 4; ++j) user.given("give").moduli(i, j, field(A, 5 * i + j, 25));
  }
};
double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return (a - b).norm() / a.norm(); }
Eigen::VectorXd values(const Workpiece<2>& body) {
  NodeBlockMatrix<2> K = body.pattern();
  body.tangent(K, TangentKind::CONSISTENT);
  return Eigen::Map<const Eigen::VectorXd>(K.value.data(), static_cast<Eigen::Index>(K.value.size()));
}

} // namespace

TEST(UserPoints, ForceTangentAndStateAreThoseOfTheLawThatWasGiven) {
  for (int nodes : {3, 6}) {
    Pair pair(nodes);
    for (double size : {0.002, 0.01, 0.014}) {
      pair.move(size);
      pair.give_stress();
      pair.give_moduli();
      EXPECT_LT(difference(pair.core.internal_force(), pair.user.internal_force()), 1e-14);
      EXPECT_LT(difference(values(pair.core), values(pair.user)), 1e-14);
      EXPECT_TRUE(same(pair.core.state(), pair.user.state()));
      pair.core.accept();
      pair.user.accept();
    }
    EXPECT_GT(internal_field(pair.core, "plastic_strain_eq").maxCoeff(), 0.003);
  }
}

TEST(UserPoints, PiolaStressServesAsWell) {
  Pair pair;
  pair.move(0.01);
  const std::vector<double> P = piola_field(pair.core);
  for (int c : {0, 1, 2, 3}) pair.user.given("give").piola(c, pair.field(P, c, 5));
  EXPECT_LT(difference(pair.core.internal_force(), pair.user.internal_force()), 1e-14);
  for (int p = 0; p < 24; ++p)
    for (int c : {0, 1, 3})
      EXPECT_NEAR(stress_at(pair.user.state(), p)[c], stress_at(pair.core.state(), p)[c], 1e-12 * 1e9);
}

// sigma = P F' / det F in large strains.
TEST(UserPoints, CauchyStressIsThatOfTheFirstPiolaStress) {
  Pair pair;
  pair.move(0.2);
  const Workpiece<2>& body = pair.core;
  const std::vector<double> P = piola_field(body), sigma = cauchy_field(body), tau = stress_field(body);
  double larger = 0;
  for (int p = 0; p < 24; ++p) {
    const double *F = &body.state().F[5 * p], *at = &P[5 * p];
    const double det = (F[0] * F[3] - F[1] * F[2]) * F[4], scale = 1e-12 * 1e9;
    EXPECT_NEAR(sigma[4 * p], (at[0] * F[0] + at[1] * F[1]) / det, scale);
    EXPECT_NEAR(sigma[4 * p + 1], (at[2] * F[2] + at[3] * F[3]) / det, scale);
    EXPECT_NEAR(sigma[4 * p + 2], at[4] * F[4] / det, scale);
    EXPECT_NEAR(sigma[4 * p + 3], (at[0] * F[2] + at[1] * F[3]) / det, scale);
    larger = std::max(larger, std::abs(tau[4 * p] - sigma[4 * p]));
  }
  EXPECT_GT(larger, 1e5) << "the two stresses differ here";
}

TEST(UserPoints, DerivativesByTheIncrementsGiveTheConsistentTangent) {
  Pair pair(6, j2_law<2>(example_material(1e15)));
  Workpiece<2> core(patch(6, 1), j2_law<2>(example_material(1e15)), single());
  const Eigen::VectorXd u = bent(core.discretization(), 1, 0.01);
  core.update(u, 1, 0);
  pair.user.update(u, 1, 0);
  const auto& elastic = example_material().elastic;
  const int points = core.discretization().num_points();
  for (int c = 0; c < 4; ++c) {
    Eigen::VectorXd t(points);
    for (int p = 0; p < points; ++p) t[p] = stress_at(core.state(), p)[c];
    pair.user.given("give").stress(c, t);
    for (int y = 0; y < 4; ++y) {
      double modulus = c == y ? 2 * elastic.G : 0;
      if (c < 3 && y < 3) modulus += elastic.K - 2 * elastic.G / 3;
      pair.user.given("give").jacobian(c, y, Eigen::VectorXd::Constant(points, modulus));
    }
    // the first step starts without stress: nothing turns
    pair.user.given("give").jacobian(c, 4, Eigen::VectorXd::Zero(points));
  }
  EXPECT_LT(difference(values(core), values(pair.user)), 1e-14);
}

TEST(UserPoints, EventsOfElementsNeedTheYieldSurfaceOnly) {
  Pair pair;
  pair.move(0.006);
  pair.give_stress();
  const auto core = element_events(pair.core, 0.), user = element_events(pair.user, 0.);
  ASSERT_GT(core.size(), 5u);
  ASSERT_EQ(core.size(), user.size());
  for (std::size_t k = 0; k < core.size(); ++k) EXPECT_EQ(core[k].fraction, user[k].fraction);
}

TEST(UserPoints, ALawWithoutCoreHasItsOwnVariables) {
  Pair pair(3, std::make_shared<UserLaw<2>>(internal_names(" damage, alpha ")));
  EXPECT_EQ(pair.user.law().internal_variables().names(), "plastic_strain_eq, damage, alpha");
  pair.move(0.01);
  pair.user.given("give").internal("damage", 0, Eigen::VectorXd::Constant(8, 0.25));
  EXPECT_EQ(internal_field(pair.user, "damage"), Eigen::VectorXd::Constant(8, 0.25));
  EXPECT_EQ(element_events(pair.user, 0.).size(), 0u);
  EXPECT_THROW(pair.user.set_user_defined(false), std::invalid_argument);
}

TEST(UserPoints, SaysWhatIsMissingOrWrong) {
  Pair pair;
  const auto says = [](const auto& call, const std::string& words) {
    try {
      call();
      ADD_FAILURE() << "no error: " << words;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(24);
  says([&] { pair.user.given("give").stress(0, ones); }, "call update first");
  says([&] { pair.core.given("give").stress(0, ones); }, "not user-defined");
  pair.move(0.01);
  pair.user.given("give").stress(0, ones);
  says([&] { pair.user.internal_force(); }, "component yy of the stress");
  says([&] { values(pair.user); }, "modulus d P_xx/d F_xx");
  pair.user.given("give").jacobian(0, 0, ones);
  says([&] { values(pair.user); }, "tau_xx by the increment of yy");
  says([&] { pair.user.given("give").stress(4, ones); }, "0..3");
  says([&] { pair.user.given("give").moduli(0, 5, ones); }, "column = 5");
  says([&] { pair.user.given("give").stress(0, Eigen::VectorXd::Ones(23)); }, "24, the number of points");
  says([&] { pair.user.given("give").internal("damage", 0, ones); }, "no internal variable");
  Eigen::VectorXd bad = ones;
  bad[7] = std::numeric_limits<double>::quiet_NaN();
  says([&] { pair.user.given("give").stress(3, bad); },
       "Kirchhoff stress xy is nan at point 7, reference place (");
  says(
      [&] {
        for (int c = 0; c < 4; ++c) pair.user.given("give").piola(c, (c + 1) * ones);
      },
      "not symmetric at point 0");
}
