// Integrity of points: carried stress and tangent, ramps over steps and parts of steps, healing, copies of the state.
#include "material/make_law.hpp"
#include "unit/finite_difference.hpp"
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double LEAST = 0.3;

Workpiece<2> tracked(int nodes = 3) {
  Workpiece<2> body{patch(nodes, 1), j2_law<2>(example_material())};
  body.track_integrity();
  return body;
}
/// Armstrong-Frederick with hardening: internal variables are a scalar and a tensor.
Workpiece<2> kinematic() {
  LawInput input;
  input.numbers = {{"G", 2.7e10}, {"nu", 0.32}, {"sigY", 1.93e8}, {"H", 9.62e8}, {"C", 5e9}, {"gamma", 30}};
  input.backstress = "armstrongfrederick";
  Workpiece<2> body{patch(3, 1), make_law<2>(input, "test")};
  body.track_integrity();
  return body;
}
void change_all(Workpiece<2>& body, double goal, int steps) {
  for (int p = 0; p < body.discretization().num_points(); ++p) body.change_integrity(p, goal, steps);
}
/// A step of bending strains of about `size`, by three iterations.
void go(Workpiece<2>& body, double size, double dt = 1) {
  for (int it = 0; it < 3; ++it)
    ASSERT_EQ(body.update(bent(body.discretization(), 1, size), dt, it).status, UpdateStatus::OK);
}
Eigen::MatrixXd dense(const Workpiece<2>& body, TangentKind kind, double blend = 0) {
  NodeBlockMatrix<2> K = body.pattern();
  body.tangent(K, kind, blend);
  const int n = body.discretization().num_nodes;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (const int slot = K.find(i, j); slot >= 0)
        A.block<2, 2>(2 * i, 2 * j) =
            Eigen::Map<const Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>(K.block(slot));
  return A;
}

} // namespace

// METHOD.md (1.27): forces, Piola stress, moduli and tangents of every kind are w times those of the law.
TEST(Integrity, ScalesStressAndTangent) {
  Workpiece<2> whole = tracked(6), damaged = tracked(6);
  change_all(damaged, LEAST, 1);
  for (Workpiece<2>* body : {&whole, &damaged}) go(*body, 0.006);
  const Eigen::VectorXd f = whole.internal_force();
  expect_close(damaged.internal_force(), LEAST * f, f.norm(), 1e-14, "force");
  for (const TangentKind kind : {TangentKind::CONSISTENT, TangentKind::RATE, TangentKind::ELASTIC}) {
    const Eigen::MatrixXd K = dense(whole, kind, 0.4);
    expect_close(dense(damaged, kind, 0.4), LEAST * K, K.norm(), 1e-14, "tangent");
  }
  for (int p = 0; p < damaged.discretization().num_points(); ++p) {
    EXPECT_EQ(integrity_of(damaged.state(), p), LEAST);
    EXPECT_EQ(integrity_of(whole.state(), p), 1);
    expect_close(carried_stress(damaged.state(), p), LEAST * carried_stress(whole.state(), p),
                 carried_stress(whole.state(), p).norm(), 1e-14, "stress");
    EXPECT_NEAR(stress_eq_field(damaged)[p], LEAST * stress_eq_field(whole)[p],
                1e-12 * stress_eq_field(whole)[p]);
    EXPECT_EQ(yield_distance(damaged, p), yield_distance(whole, p)) << "the law's own stress decides";
    EXPECT_EQ(damaged.state().internal[p], whole.state().internal[p]);
  }
}

// Without damage nothing is kept, and with every integrity at 1 not a bit changes.
TEST(Integrity, OfOneChangesNoBit) {
  Workpiece<2> plain{patch(6, 1), j2_law<2>(example_material())}, body = tracked(6);
  EXPECT_TRUE(plain.state().integrity.empty());
  for (Workpiece<2>* each : {&plain, &body}) {
    go(*each, 0.004);
    each->accept();
    go(*each, 0.007);
  }
  EXPECT_EQ(plain.internal_force(), body.internal_force());
  EXPECT_EQ(dense(plain, TangentKind::CONSISTENT, 0.2), dense(body, TangentKind::CONSISTENT, 0.2));
  EXPECT_EQ(integrity_of(plain.state(), 0), 1);
}

// The tangent against differences of the force while some points crumble, some heal, some flow. In a direction v the
// symmetric part gives v'Kv exactly.
TEST(Integrity, TangentIsTheDerivativeOfTheForce) {
  for (const bool with_backstress : {false, true}) {
    Workpiece<2> body = with_backstress ? kinematic() : tracked(3);
    const int points = body.discretization().num_points();
    go(body, 0.006);
    body.accept();
    change_all(body, 0.2, 1);
    go(body, 0.0065);
    body.accept();
    for (int p = 0; p < points; ++p)
      if (p % 2)
        body.change_integrity(p, 1, 3);
      else
        body.change_integrity(p, 0.1, 2);
    go(body, 0.009);
    const Eigen::VectorXd u = bent(body.discretization(), 1, 0.009);
    const Eigen::MatrixXd K = dense(body, TangentKind::CONSISTENT);
    expect_close(K, K.transpose(), K.norm(), 1e-15, "symmetry");
    int flows = 0;
    for (const char plastic : body.state().plastic) flows += plastic;
    EXPECT_GT(flows, 0);
    for (int k = 0; k < 5; ++k) {
      const Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(
          u.size(), [&](Eigen::Index i) { return std::sin(1.7 * static_cast<double>(i) + k); });
      const double slope = finite_difference(
          [&](double t) {
            body.update(u + t * v, 1, 3);
            return v.dot(body.internal_force());
          },
          0., 1e-7);
      EXPECT_NEAR(v.dot(K * v) / slope, 1, 1e-6) << with_backstress << ", direction " << k;
    }
  }
}

// METHOD.md (1.28): equal parts a step, from the step after the change on; parts of a step by their share.
TEST(Integrity, FallsOverStepsAndPartsOfSteps) {
  Workpiece<2> body = tracked();
  body.change_integrity(2, 0.2, 4);
  EXPECT_EQ(integrity_of(body.state(), 2), 1) << "the accepted state is still whole";
  const double expected[] = {0.8, 0.6, 0.4, 0.2, 0.2};
  for (const double w : expected) {
    go(body, 0.001, 0.37); // any length is one step
    EXPECT_NEAR(integrity_of(body.state(), 2), w, 1e-15);
    EXPECT_EQ(integrity_of(body.state(), 1), 1);
    body.accept();
  }
  EXPECT_EQ(body.state().integrity[2], 0.2) << "exactly";
  EXPECT_EQ(body.state().integrity_rate[2], 0);

  body.change_integrity(2, 1, 2);
  body.set_step_length(1);
  const double parts[] = {0.1, 0.25, 0.65, 0.3, 0.7}, after[] = {0.24, 0.34, 0.6, 0.72, 1};
  for (int k = 0; k < 5; ++k) {
    go(body, 0.001, parts[k]);
    EXPECT_NEAR(integrity_of(body.state(), 2), after[k], 1e-14);
    body.accept();
  }
  EXPECT_EQ(body.state().integrity[2], 1);
  EXPECT_EQ(body.state().integrity_rate[2], 0);
}

// What heals is new and free of stress as it stands, METHOD.md (1.29): forces go on, whatever is left is mixed in by its
// part, and a whole healed point follows the virgin law.
TEST(Integrity, HealingForgets) {
  for (const bool with_backstress : {false, true}) {
    Workpiece<2> body = with_backstress ? kinematic() : tracked(3);
    go(body, 0.008);
    body.accept();
    change_all(body, 1e-3, 1);
    go(body, 0.008);
    body.accept();
    const Eigen::VectorXd carried = body.internal_force();
    const WorkpieceState<2> before = body.state();
    EXPECT_GT(before.internal[0], 1e-3);
    change_all(body, 1, 5);
    for (int step = 1; step <= 5; ++step) {
      go(body, 0.008); // nothing moves
      expect_close(body.internal_force(), carried, carried.norm(), 1e-13, "force while healing");
      const double w = 1e-3 + step * 0.999 / 5;
      for (std::size_t k = 0; k < before.internal.size(); ++k)
        EXPECT_NEAR(body.state().internal[k], 1e-3 / w * before.internal[k],
                    1e-12 * std::abs(before.internal[k]));
      body.accept();
    }
    // from here on as a body without a past that is strained by as much
    Workpiece<2> fresh{patch(3, 1), j2_law<2>(example_material())};
    go(body, 0.0083);
    EXPECT_LT(*std::max_element(body.state().plastic.begin(), body.state().plastic.end()), 1);
    const Eigen::VectorXd gained = body.internal_force() - carried;
    const double small = 1e-6;
    fresh.update(small * bent(fresh.discretization(), 1, 1), 1, 0);
    const Eigen::VectorXd per_strain = fresh.internal_force() / small;
    expect_close(gained, 3e-4 * per_strain, gained.norm(), 0.03,
                 "whole stiffness, to the order of the strain");
  }
}

// Copies go on to the same bits, revert restores, a state of the other kind is refused.
TEST(Integrity, IsPartOfTheState) {
  Workpiece<2> body = kinematic();
  go(body, 0.006);
  body.accept();
  body.change_integrity(0, 0.1, 3);
  body.change_integrity(3, 0.4, 2);
  go(body, 0.0065);
  body.accept();
  body.change_integrity(3, 1, 4);
  const WorkpieceState<2> saved = body.state_old();
  EXPECT_EQ(saved.integrity[0], 1 - 0.3);
  go(body, 0.009);
  EXPECT_GT(integrity_of(body.state(), 3), saved.integrity[3]);
  body.revert();
  EXPECT_EQ(body.state().integrity, saved.integrity);
  EXPECT_EQ(body.state().integrity_rate, saved.integrity_rate);
  EXPECT_EQ(body.state().stress, saved.stress) << "healing has left the accepted state alone";
  Workpiece<2> copy = kinematic();
  copy.set_state(saved);
  for (int step = 0; step < 4; ++step) {
    for (Workpiece<2>* each : {&body, &copy}) go(*each, 0.007 + 5e-4 * step);
    EXPECT_EQ(body.internal_force(), copy.internal_force());
    EXPECT_EQ(dense(body, TangentKind::CONSISTENT), dense(copy, TangentKind::CONSISTENT));
    for (Workpiece<2>* each : {&body, &copy}) each->accept();
    EXPECT_TRUE(same(body.state(), copy.state()));
  }
  Workpiece<2> plain{patch(3, 1), j2_law<2>(example_material())};
  expect_invalid([&] { plain.set_state(tracked().state()); }, "tracks none");
  expect_invalid([&] { tracked().set_state(plain.state()); }, "size of integrity = 0");
  WorkpieceState<2> wrong = saved;
  wrong.integrity[1] = 0;
  expect_invalid([&] { copy.set_state(wrong); }, "integrity = 0, expected 0 < integrity <= 1");
}

TEST(Integrity, RefusesWhatItCannotDo) {
  Workpiece<2> body = tracked(), plain{patch(3, 1), j2_law<2>(example_material())};
  expect_invalid([&] { plain.change_integrity(0, 0.5, 1); }, "no integrity is tracked");
  expect_invalid([&] { body.change_integrity(0, 0, 1); }, "goal = 0");
  expect_invalid([&] { body.change_integrity(0, 1.1, 1); }, "goal = 1.1");
  expect_invalid([&] { body.change_integrity(0, 0.5, 0); }, "steps = 0");
  expect_invalid([&] { body.change_integrity(8, 0.5, 1); }, "point = 8");
  expect_invalid([&] { body.set_step_length(-1); }, "length = -1");
  body.change_integrity(0, 0.5, 1);
  body.update(Eigen::VectorXd::Zero(body.discretization().num_dofs()), 1, 0);
  body.accept();
  body.set_user_defined(true);
  expect_invalid([&] { body.change_integrity(0, 1, 1); },
                 "the law is user-defined: the stress that it keeps");
}

// Two cells in a row between fixed ends, sides guided: after the first has lost integrity the forces balance anew. The
// law's own strain of a step from stretch a to b is 2(b - a)/(a + b), the force of a cell w M e/stretch.
TEST(Integrity, BarOfTwoElementsSharesTheForceAnew) {
  const Discretization<2> mesh =
      triangles(3, {0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1}, {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4});
  Workpiece<2> body{mesh, j2_law<2>(example_material(1e15))};
  body.track_integrity();
  const double modulus = body.law().modulus("K") + 4. / 3 * body.law().modulus("G"), l = 1.02, w = 0.25;
  const auto place = [&](double middle) { // of the nodes at x = 1; the end is at 2 l
    Eigen::VectorXd u = Eigen::VectorXd::Zero(12);
    u[2] = u[8] = middle - 1;
    u[4] = u[10] = 2 * l - 2;
    return u;
  };
  body.update(place(l), 1, 0);
  body.accept();
  for (const int p : {0, 1}) body.change_integrity(p, w, 1);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(12);
  v[2] = v[8] = 1;
  double middle = l;
  for (int it = 0; it < 6; ++it) { // Newton's method: quadratic with the exact tangent
    body.update(place(middle), 1, it);
    middle -= v.dot(body.internal_force()) / v.dot(dense(body, TangentKind::CONSISTENT) * v);
  }
  body.update(place(middle), 1, 6);
  const auto strain = [](double a, double b) { return 2 * (b - a) / (a + b); };
  const auto force = [&](double stretch, double part) {
    return part * modulus * (strain(1, l) + strain(l, stretch)) / stretch;
  };
  double low = l, high = 2 * l - 1; // by bisection
  for (int it = 0; it < 100; ++it) {
    const double at = 0.5 * (low + high);
    (force(at, w) < force(2 * l - at, 1) ? low : high) = at;
  }
  EXPECT_NEAR(middle, low, 1e-12);
  const Eigen::VectorXd f = body.internal_force();
  EXPECT_NEAR((f[4] + f[10]) / force(low, w), 1, 1e-9);
  const double linear = modulus * (l - 1) * 2 * w / (1 + w); // small strain: M e 2w/(1 + w)
  EXPECT_NEAR((f[4] + f[10]) / linear, 1, 0.05);
}
