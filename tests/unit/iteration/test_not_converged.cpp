// What a stop is called: a limit load where a tool goes on one way under its force, not where contact states go to and fro.
#include "diagnosis/words.hpp"
#include "iteration/not_converged.hpp"
#include "unit/contact/spring_body.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A line that two nodes slide on, far from balance; its y under force.
struct Unbalanced {
  SpringBody spring{0};
  SpringContact contact;
  IterationOptions options;
  Eigen::VectorXd u, R;
  std::unique_ptr<StepBalance<2>> balance;

  Unbalanced() {
    contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), 0.3);
    contact.touch(0, 0, 0.4, 1, true);
    contact.touch(2, 0, 0.9, 0, false);
    u = 0.1 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().sin();
    contact.settle(spring.body, u);
    contact.prescribed.is_motion = {1, 0, 1};
    contact.prescribed.value = contact.state.q;
    R = spring.force(u);
    balance = std::make_unique<StepBalance<2>>(contact.model, spring.body, options);
    balance->look(contact.state, contact.prescribed, u, R);
  }
  /// Of ten iterations. @param last increment of y over the first; @param way all of them over the first
  Failure failure(double last, double way, int unsolved = 0) const {
    const Eigen::VectorXd first = 0.2 * Eigen::VectorXd::Unit(3, 1);
    const Eigen::VectorXd dq = last * first, gone = way * first;
    return not_converged<2>({contact.model, spring.body, contact.state, contact.prescribed, *balance, options,
                             10, unsolved, balance->last().residual, dq, gone, first, u, R});
  }
  bool says(const Failure& failure, const char* what) const {
    return words(failure, contact.model).find(what) != std::string::npos;
  }
};

} // namespace

TEST(NotConverged, LimitLoadGoesOnOneWay) {
  const Unbalanced scene;
  for (const double last : {0.5, 1., 3.}) {
    const Failure failure = scene.failure(last, 6);
    EXPECT_EQ(failure.cause, Cause::NO_BALANCE);
    EXPECT_TRUE(failure.limit_load());
    EXPECT_TRUE(scene.says(failure, "a limit load"));
    EXPECT_FALSE(scene.says(failure, "to and fro"));
  }
}

TEST(NotConverged, ToAndFroIsNoLimitLoad) {
  const Unbalanced scene;
  EXPECT_FALSE(scene.failure(-1, 6).limit_load()) << "back in the last iteration";
  EXPECT_FALSE(scene.failure(1, 0.5).limit_load()) << "back in those before";
  EXPECT_FALSE(scene.failure(0.05, 6).limit_load()) << "at rest";
  EXPECT_FALSE(scene.failure(1, 6, 1).limit_load()) << "no states of the window agree";
}

// The states that contradict the forces are counted by the balance.
TEST(NotConverged, StatesThatContradictTheForcesAreNamed) {
  const Unbalanced scene;
  Failure failure = scene.failure(1, 0.5);
  for (const int inconsistent : {0, 3}) {
    failure.last.inconsistent = inconsistent;
    EXPECT_EQ(scene.says(failure, "states go to and fro"), inconsistent > 0);
    EXPECT_FALSE(scene.says(failure, "limit load"));
  }
}
