// The rows of a sliding node, T + m g(N) = 0: residual and derivatives by finite differences, in the plane and in
// space; independent of the choice of the tangents.
#include "contact/formula_friction.hpp"
#include "contact/tangential_law.hpp"
#include "unit/contact/surface_sample.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double AREA = 0.7;

template <class Dimension> struct SlidingRowsOf : testing::Test {
  static constexpr int Dim = Dimension::value;
  using Along = Param<Dim>;
  const SurfaceSample<Dim> sample{11};
  const SurfacePoint<Dim> p = sample.point();
  const Along m = Along::LinSpaced(1, -0.5).normalized();
  const Vector<Dim> F = 5 * p.n + p.E * (-1.3 * m + 0.4 * Along::Unit(0)); // not in balance

  static std::vector<TangentialLaw<Dim>> laws() {
    const auto make = [](std::shared_ptr<const FrictionLaw> law) {
      return TangentialLaw<Dim>(std::move(law));
    };
    return {make(make_coulomb(0)),
            make(make_coulomb(0.3)),
            make(make_tresca(2)),
            make(make_limited_coulomb(0.3, 90)),
            make(make_formula_friction("mu*p/(1 + p/p0)", {{"mu", 0.4}, {"p0", 9}})),
            make(make_formula_friction("0.5 + tanh(0.2*p)"))};
  }
  Along direction(const TangentialLaw<Dim>& law) const {
    return law.frictionless() ? Along(Along::Zero()) : m;
  }
  static Along residual(const TangentialLaw<Dim>& law, const Tangents<Dim>& E, const Vector<Dim>& n,
                        const Vector<Dim>& F, const Along& m) {
    return E.transpose() * F + m * law.friction().limit(n.dot(F), AREA);
  }
  /// The residual where the node has slipped to c and the tool has turned; the direction of slip is fixed in the tool.
  Along residual_at(const TangentialLaw<Dim>& law, const Along& c, double angle) const {
    const Tangents<Dim> E = sample.tangents(c, angle);
    Along along = E.transpose() * (sample.rotation(angle) * (p.E * direction(law)));
    if (along.norm() > 0) along.normalize();
    return residual(law, E, sample.normal(c, angle), F, along);
  }
};
using Both = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SlidingRowsOf, Both);

} // namespace

TYPED_TEST(SlidingRowsOf, SampleIsASurface) {
  constexpr int Dim = TestFixture::Dim;
  for (int a = 0; a < Dim - 1; ++a) {
    const auto moved = [&](double c) { return this->sample.normal(c * Param<Dim>::Unit(a), 0); };
    expect_close(Vector<Dim>(this->p.E * this->p.B.col(a)), finite_difference(moved, 0, 1e-3), 1, 1e-10,
                 "dn");
  }
  EXPECT_NEAR((this->p.E.transpose() * this->p.n).norm(), 0, 1e-15);
}

TYPED_TEST(SlidingRowsOf, ResidualAtTheForce) {
  for (const auto& law : this->laws()) {
    const auto m = this->direction(law);
    const auto rows = law.rows(this->p, this->F, m, AREA);
    const Param<TestFixture::Dim> linear = rows.W.transpose() * this->F + rows.constant,
                                  exact = this->residual(law, this->p.E, this->p.n, this->F, m);
    expect_close(linear, exact, 1, 1e-14, "W'F + constant");
    const SurfaceForce<TestFixture::Dim> force{this->F.dot(this->p.n), this->p.E.transpose() * this->F};
    EXPECT_NEAR(law.sliding_residual({force, AREA}, m), exact.norm(), 1e-14);
  }
}

TYPED_TEST(SlidingRowsOf, DerivativeByTheForce) {
  constexpr int Dim = TestFixture::Dim;
  for (const auto& law : this->laws()) {
    const auto m = this->direction(law);
    const auto rows = law.rows(this->p, this->F, m, AREA);
    for (int c = 0; c < Dim; ++c) {
      const auto pulled = [&](double f) {
        return this->residual(law, this->p.E, this->p.n, this->F + f * Vector<Dim>::Unit(c), m);
      };
      const Param<Dim> W = rows.W.row(c).transpose();
      expect_close(W, finite_difference(pulled, 0, 1e-3), 1, 1e-10, "W, component " + std::to_string(c));
    }
  }
}

TYPED_TEST(SlidingRowsOf, DerivativeByTheNodesSlip) {
  constexpr int Dim = TestFixture::Dim;
  for (const auto& law : this->laws()) {
    const auto rows = law.rows(this->p, this->F, this->direction(law), AREA);
    for (int a = 0; a < Dim - 1; ++a) {
      const auto slipped = [&](double c) { return this->residual_at(law, c * Param<Dim>::Unit(a), 0); };
      const Param<Dim> column = rows.by_slip.col(a);
      expect_close(column, finite_difference(slipped, 0, 1e-3), 5, 1e-10, "by slip " + std::to_string(a));
    }
  }
}

TYPED_TEST(SlidingRowsOf, DerivativeByTheToolsCoordinates) {
  constexpr int Dim = TestFixture::Dim;
  for (const auto& law : this->laws()) {
    const auto rows = law.rows(this->p, this->F, this->direction(law), AREA);
    const auto turned = [&](double angle) { return this->residual_at(law, Param<Dim>::Zero(), angle); };
    const Param<Dim> by_angle = rows.by_q.col(0), by_offset = rows.by_q.col(1);
    expect_close(by_angle, finite_difference(turned, 0, 1e-3), 5, 1e-10, "by the angle");
    EXPECT_EQ(by_offset.norm(), 0) << "a translation turns nothing";
  }
}

// A kink: where the limited law has reached its strength, m no longer couples to N.
TYPED_TEST(SlidingRowsOf, BeyondTheKinkOfTheLimitedLaw) {
  const TangentialLaw<TestFixture::Dim> law(make_limited_coulomb(0.3, 1));
  const auto rows = law.rows(this->p, this->F, this->m, AREA); // g = 0.7 < 0.3 x 5
  EXPECT_EQ(rows.W, this->p.E);
  expect_close(rows.constant, Param<TestFixture::Dim>(0.7 * this->m), 1, 1e-15, "constant");
}

// In space the tangents may be any pair: vectors turn with them, numbers stay.
TEST(SlidingRowsInSpace, TangentsMayBeTurned) {
  using Fixture = SlidingRowsOf<std::integral_constant<int, 3>>;
  struct Open : Fixture {
    void TestBody() override {}
  } open;
  const Tensor<2> Q = Eigen::Rotation2Dd(0.8).toRotationMatrix();
  const SurfacePoint<3> other = turned<3>(open.p, Q);
  const ContactTolerance tolerance{1e-9, 1e-9};
  for (const auto& law : Fixture::laws()) {
    const Param<3> m = open.direction(law), n = Q.transpose() * m;
    const auto a = law.rows(open.p, open.F, m, AREA), b = law.rows(other, open.F, n, AREA);
    expect_close(b.W, Tangents<3>(a.W * Q), 1, 1e-14, "W");
    expect_close(b.constant, Param<3>(Q.transpose() * a.constant), 1, 1e-14, "constant");
    expect_close(b.by_slip, Tensor<2>(Q.transpose() * a.by_slip * Q), 5, 1e-14, "by slip");
    expect_close(b.by_q, Eigen::MatrixXd(Q.transpose() * a.by_q), 5, 1e-14, "by q");
    const SurfaceForce<3> force{5, open.p.E.transpose() * open.F}, same{5, Q.transpose() * force.T};
    EXPECT_NEAR(law.sliding_residual({same, AREA}, n), law.sliding_residual({force, AREA}, m), 1e-14);
    EXPECT_NEAR(law.reserve({same, AREA}), law.reserve({force, AREA}), 1e-14);
    expect_close(law.slip_against(same.T), Param<3>(Q.transpose() * law.slip_against(force.T)), 1, 1e-15,
                 "slip");
    for (const Param<3>& slip : {Param<3>(0.2, 0.1), Param<3>(-0.3, 0.05), Param<3>(0.1, 0.4)})
      for (const NodeState state : {NodeState::SLIDING, NodeState::STICKING})
        EXPECT_EQ(law.test(state, same.N, {same, AREA}, Q.transpose() * slip, n, tolerance),
                  law.test(state, force.N, {force, AREA}, slip, m, tolerance));
  }
}
