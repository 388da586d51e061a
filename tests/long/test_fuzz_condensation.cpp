// The condensed system of any input: a system of finite numbers, or an error; its solution goes back to the nodes.
#include "long/fuzz.hpp"
#include "unit/contact/spring_body.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

double odd(Random& random) {
  const double values[] = {0., -0., 1., -1., 1e-300, 1e150, -1e150, 1e30};
  return random.chance(0.2) ? values[random.whole(0, 7)] : random.between(-1, 1);
}

/// One scene of two nodes on a roller, everything else by chance. True: it was condensed.
bool condensed(Random& random) {
  SpringBody spring(0.3);
  SpringContact contact;
  const double mu = random.chance(0.5) ? 0 : random.between(0, 2);
  contact.add(make_tool("roller", Shape::CIRCLE, Frame::POLAR), mu);
  contact.touch(random.whole(1, 2), 0, random.between(-3, 3), mu > 0 ? -1 : 0, random.chance(0.5));
  if (random.chance(0.7)) contact.touch(3, 0, random.between(-3, 3), 0, false);
  for (int i = random.whole(0, 4); i > 0; --i) spring.body.fixed[random.whole(0, 23)] = 1;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(24), R(24);
  contact.settle(spring.body, u);
  NodeBlockMatrix<2> K = spring.tangent(u);
  for (double& value : K.value)
    if (random.chance(0.1)) value = odd(random);
  for (double& value : R) value = odd(random);
  for (double& value : u)
    if (random.chance(0.1)) value = odd(random);
  contact.prescribed.value = Vector<3>(odd(random), contact.state.q[1] + odd(random), odd(random));
  for (int k = 0; k < 3; ++k) contact.prescribed.is_motion[k] = random.chance(0.5);
  Condensation<2> condensation(contact.model, spring.body);
  const auto terms = static_cast<GeometricTerms>(random.whole(0, 2));
  const auto right = random.chance(0.5) ? RightHandSide::TOTAL : RightHandSide::RATES;
  try {
    const CondensedSystem& system = condensation.condense(
        {K, contact.state, contact.prescribed, contact.prescribed, u, R, terms, right, random.chance(0.3)});
    EXPECT_EQ(static_cast<int>(system.rhs.size()), system.n);
    EXPECT_EQ(static_cast<int>(system.row_start.size()), system.n + 1);
    for (int row = 0; row < system.n; ++row)
      for (int k = system.row_start[row]; k < system.row_start[row + 1]; ++k) {
        EXPECT_TRUE(system.col[k] >= 0 && system.col[k] < (system.half ? row + 1 : system.n));
        EXPECT_TRUE(k == system.row_start[row] || system.col[k] > system.col[k - 1]);
      }
    Eigen::VectorXd z(system.n);
    for (double& value : z) value = odd(random);
    EXPECT_EQ(condensation.expand(z).du.size(), 24);
    EXPECT_THROW(condensation.expand(z.head(system.n - 1)), std::invalid_argument);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

} // namespace

TEST(FuzzCondensation, AnyInputGivesASystemOrAnError) {
  Random random(1);
  int done = 0;
  for (int i = 0; i < 3000; ++i) done += condensed(random);
  EXPECT_GT(done, 1500);
}
