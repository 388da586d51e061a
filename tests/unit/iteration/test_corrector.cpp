// The iteration inside a step on a body whose tangent is known exactly.
#include "diagnosis/words.hpp"
#include "iteration/condensed_iteration.hpp"
#include "iteration/corrector.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/contact/spring_body.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A linear spring body under a line, two nodes sliding, one sticking; x and y under motion, the angle too.
struct Held {
  SpringBody spring{0};
  SpringContact contact;
  std::unique_ptr<Iteration<2>> iteration;
  std::unique_ptr<Corrector<2>> corrector;
  Eigen::VectorXd u;

  explicit Held(double nonlinear = 0, const IterationOptions& options = {}) : spring(nonlinear) {
    contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), 0.3);
    contact.touch(0, 0, 0.4, 1, true);
    contact.touch(2, 0, 0.9, 0, false);
    contact.touch(4, 0, 1.3, -1, true);
    spring.body.fixed[0] = spring.body.fixed[1] = 1;
    u = 0.1 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().sin();
    contact.settle(spring.body, u);
    contact.prescribed.is_motion = {1, 1, 1};
    contact.prescribed.value = contact.state.q + Vector<3>(0.01, -0.02, 0.01);
    iteration = std::make_unique<Iteration<2>>(contact.model, spring.body, options);
    corrector = std::make_unique<Corrector<2>>(*iteration);
  }
  void begin(bool adapt = false) {
    ContactState<2> predicted = contact.state;
    predicted.q = contact.prescribed.value;
    iteration->begin(contact.prescribed, predicted,
                     {predicted.nodes, std::vector<EntryRecord>(predicted.nodes.size())}, adapt);
    corrector->begin(false);
  }
  /// Two iterations by one tangent. @returns the displacement before the second
  Eigen::VectorXd iterate_twice(bool adapt) {
    begin(adapt);
    Eigen::VectorXd before;
    for (int k = 0; k < 2; ++k) {
      EXPECT_EQ(iteration->check(u, spring.force(u)), StepStatus::ITERATE);
      if (k == 0) {
        EXPECT_EQ(corrector->factorize(spring.tangent(u), u), FactorStatus::OK);
      }
      before = u;
      EXPECT_EQ(corrector->correct(u, spring.force(u)), StepStatus::ITERATE);
    }
    return before;
  }
  /// Iterates to the end. @returns the last status
  StepStatus solve() {
    begin();
    for (;;) {
      StepStatus status = iteration->check(u, spring.force(u));
      if (status == StepStatus::BACKTRACKED) corrector->forget_mixing();
      if (status == StepStatus::ITERATE && !corrector->serves(u)) status = StepStatus::REFACTORIZE;
      if (status == StepStatus::CONVERGED || status == StepStatus::FAILED) return status;
      if (status == StepStatus::BACKTRACKED) continue;
      if (status == StepStatus::REFACTORIZE) {
        EXPECT_EQ(corrector->factorize(spring.tangent(u), u), FactorStatus::OK);
      }
      if (corrector->correct(u, spring.force(u)) == StepStatus::FAILED) return StepStatus::FAILED;
    }
  }
  double unbalanced() {
    const Eigen::VectorXd R = spring.force(u);
    double worst = 0;
    for (Eigen::Index d = 0; d < u.size(); ++d) {
      bool free = !spring.body.fixed[d];
      for (std::size_t i = 0; i < 6; ++i)
        free =
            free && !(in_contact(iteration->state().nodes[i].state) && contact.model.candidates[i] == d / 2);
      if (free) worst = std::max(worst, std::abs(R[d]));
    }
    return worst;
  }
};

} // namespace

TEST(Corrector, LinearBodyUnderALineTakesOneFactor) {
  IterationOptions options;
  options.tolerance = 1e-10;
  Held held(0, options);
  ASSERT_EQ(held.solve(), StepStatus::CONVERGED) << words(held.iteration->failure(), held.contact.model);
  EXPECT_EQ(held.iteration->counts().factorizations, 1);
  EXPECT_LE(held.iteration->counts().iterations, 4);
  EXPECT_LE(held.unbalanced(), 1e-9);
  EXPECT_EQ(held.iteration->state().q, held.contact.prescribed.value);
}

TEST(Corrector, NonlinearBodyConvergesByTheSameFactor) {
  IterationOptions options;
  options.tolerance = 1e-10;
  options.max_iterations = 60;
  Held held(0.3, options);
  ASSERT_EQ(held.solve(), StepStatus::CONVERGED) << words(held.iteration->failure(), held.contact.model);
  EXPECT_LE(held.unbalanced(), 1e-9);
}

// ALGORITHMS.md (5.5): back to where the work of the forces along the increment has its minimum, and on from there with a new tangent.
TEST(Corrector, AWayBackEndsInANewTangent) {
  IterationOptions options;
  options.tolerance = 1e-12;
  Held held(0.3, options);
  Iteration<2>& iteration = *held.iteration;
  const Eigen::VectorXd before = held.iterate_twice(true);
  const Eigen::VectorXd all = held.u, du = all - before, R0 = held.spring.force(before);
  const auto& model = held.contact.model;
  const std::vector<char> counted = free_of_contact(held.spring.body, model.candidates, iteration.state());
  const auto slope = [&](const Eigen::VectorXd& R) {
    double sum = 0;
    for (Eigen::Index d = 0; d < du.size(); ++d) sum += counted[d] ? du[d] * R[d] : 0;
    return sum;
  };
  ASSERT_LT(slope(R0), 0);
  Eigen::VectorXd beyond =
      R0; // forces that have turned: the slope at the end is twice that at the start, with the other sign
  for (Eigen::Index d = 0; d < du.size(); ++d)
    if (counted[d]) beyond[d] = -2 * R0[d];
  ASSERT_EQ(iteration.check(held.u, beyond), StepStatus::BACKTRACKED);
  expect_close(held.u, before + du / 3, du.cwiseAbs().maxCoeff(), 1e-12, "what is left of the increment");
  EXPECT_EQ(iteration.check(held.u, held.spring.force(held.u)), StepStatus::REFACTORIZE);
}

// The same in a piece between events: half of the increment, once, where the residual has grown.
TEST(Corrector, APieceGoesHalfWayBack) {
  IterationOptions options;
  options.tolerance = 1e-12;
  Held held(0.3, options);
  Iteration<2>& iteration = *held.iteration;
  const Eigen::VectorXd before = held.iterate_twice(false), du = held.u - before;
  const Eigen::VectorXd grown = 100 * held.spring.force(before);
  ASSERT_EQ(iteration.check(held.u, grown), StepStatus::BACKTRACKED);
  expect_close(held.u, before + du / 2, du.cwiseAbs().maxCoeff(), 1e-12, "what is left of the increment");
  EXPECT_EQ(iteration.check(held.u, grown), StepStatus::REFACTORIZE);
}

// One iteration by the condensed system is one by factor and dense block.
TEST(Corrector, AdvanceIsCorrectOnALinearBody) {
  Held dense(0), sparse(0);
  dense.begin();
  dense.iteration->check(dense.u, dense.spring.force(dense.u));
  dense.corrector->factorize(dense.spring.tangent(dense.u), dense.u);
  dense.corrector->correct(dense.u, dense.spring.force(dense.u));

  sparse.begin();
  sparse.iteration->check(sparse.u, sparse.spring.force(sparse.u));
  CondensedIteration<2> way(*sparse.iteration);
  way.begin();
  way.prepare();
  Condensation<2> condensation(sparse.contact.model, sparse.spring.body);
  const auto& prescribed = sparse.contact.prescribed;
  const auto& system = condensation.condense({sparse.spring.tangent(sparse.u), sparse.iteration->state(),
                                              prescribed, prescribed, sparse.u, sparse.spring.force(sparse.u),
                                              GeometricTerms::COMPLETE, RightHandSide::TOTAL, false});
  UnsymmetricSolver solver;
  ASSERT_EQ(solver.factorize(view(system)), FactorStatus::OK);
  way.advance(condensation.expand(solver.solve(system.rhs)), sparse.u);
  expect_close(sparse.u, dense.u, dense.u.cwiseAbs().maxCoeff(), 1e-11, "displacement");
}

TEST(Corrector, IndefiniteTangentIsNoFactor) {
  Held held;
  held.begin();
  held.iteration->check(held.u, held.spring.force(held.u));
  NodeBlockMatrix<2> K = held.spring.tangent(held.u);
  for (double& value : K.value) value = -value;
  EXPECT_EQ(held.iteration->policy().elastic_blend(), 0);
  double blend = 0;
  for (int attempt = 0; attempt <= TangentPolicy::MAX_INDEFINITE; ++attempt) {
    EXPECT_EQ(held.corrector->factorize(K, held.u), FactorStatus::NOT_POSITIVE_DEFINITE);
    EXPECT_GT(held.iteration->policy().elastic_blend(), blend);
    if (attempt < 3) blend = held.iteration->policy().elastic_blend() - 1e-3;
  }
  EXPECT_TRUE(held.iteration->policy().blend_exhausted());
  expect_invalid([&] { held.corrector->correct(held.u, held.spring.force(held.u)); },
                 "no factor: call factorize first");
}

TEST(Corrector, GivesUpAfterItsIterations) {
  IterationOptions options;
  options.tolerance = 1e-12;
  options.max_iterations = 1;
  Held held(0.3, options);
  EXPECT_EQ(held.solve(), StepStatus::FAILED);
  EXPECT_EQ(words(held.iteration->failure(), held.contact.model).find("no convergence in "), 0u);
}

// What memory() holds is all that the next step needs: a corrector of the same problem goes on to the same bits.
TEST(Corrector, MemoryIsEnough) {
  Held first(0.3), second(0.3);
  ASSERT_EQ(first.solve(), StepStatus::CONVERGED);
  second.u = first.u;
  second.iteration->balance().memory() = first.iteration->balance().memory();
  second.corrector->restore(first.corrector->memory());
  for (Held* held : {&first, &second}) {
    held->contact.state = first.iteration->state();
    held->contact.prescribed.value[1] = -0.05 + held->contact.prescribed.value[1];
  }
  const ContactState<2> reached = first.iteration->state();
  first.contact.state = second.contact.state = reached;
  EXPECT_EQ(first.solve(), second.solve());
  EXPECT_EQ(first.u, second.u);
}

TEST(CorrectorErrors, SizesAndNaN) {
  Held held;
  held.begin();
  expect_invalid([&] { held.iteration->check(held.u, Eigen::VectorXd::Zero(4)); },
                 "size of the force array = 4");
  Eigen::VectorXd R = held.spring.force(held.u);
  R[3] = std::nan("");
  expect_invalid([&] { held.iteration->check(held.u, R); }, "the force array contains NaN or Inf");
  ContactModel<2> none;
  none.first = {0};
  expect_invalid([&] { Iteration<2>(none, held.spring.body, {}); }, "number of candidate nodes = 0");
}
