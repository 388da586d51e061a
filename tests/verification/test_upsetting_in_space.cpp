// Frictionless upsetting of a block in space, J2 with linear hardening, as a homogeneous deformation of a distorted mesh:
// F = (Y + H L)/(1 + H/E) A0 h0/h with L = ln(h0/h), as derived in test_upsetting.cpp for the cylinder; without the
// elastic part the force of METHOD.md 8, C18.
#include "material/j2/law.hpp"
#include "support/equilibrium.hpp"
#include "support/tetrahedra.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const double Y = 200, E = 2e5;

struct Block {
  Workpiece<3> body;
  std::vector<char> held;
  Eigen::VectorXd u;
  double height = 1;
  explicit Block(int nodes) : body(mesh(nodes), j2_law<3>(J2Parameters::from_young(E, 0.3, Y, Y))) {
    const Discretization<3>& d = body.discretization();
    u = Eigen::VectorXd::Zero(d.num_dofs());
    held.assign(d.num_dofs(), 0);
    for (int a = 0; a < d.num_nodes; ++a) {
      for (int c = 0; c < 3; ++c) held[3 * a + c] = d.node(a)[c] < 1e-9; // planes of symmetry
      if (top(a)) held[3 * a + 2] = 1;
    }
  }
  static Discretization<3> mesh(int nodes) {
    const Mesh<3> linear = block_of_tetrahedra(2, 2, 2, [](double x, double y, double z) {
      const double bump = 0.1 * std::sin(M_PI * x) * std::sin(M_PI * y) * std::sin(M_PI * z);
      return Vector<3>(x + bump, y - 0.7 * bump, z + 0.5 * bump);
    });
    return tetrahedra(nodes == 4 ? linear : quadratic_tetrahedra(linear));
  }
  bool top(int a) const { return body.discretization().node(a)[2] > 1 - 1e-9; }
  /// Height over the first one after n steps that are equal in the logarithm. @return force, positive in compression
  double press(double to, int n) {
    const double from = height;
    for (int k = 1; k <= n; ++k) {
      const double next = from * std::pow(to / from, 1. * k / n), wide = std::pow(next, -0.5);
      for (int a = 0; a < body.discretization().num_nodes; ++a) {
        const Vector<3> X = body.discretization().node(a);
        u.segment<3>(3 * a) << (wide - 1) * X[0], (wide - 1) * X[1], (next - 1) * X[2];
      }
      equilibrate(body, held, u);
      if (testing::Test::HasFatalFailure()) return 0;
      body.accept();
    }
    height = to;
    double sum = 0;
    const Eigen::VectorXd R = body.internal_force();
    for (int a = 0; a < body.discretization().num_nodes; ++a)
      if (top(a)) sum -= R[3 * a + 2];
    return sum;
  }
};

} // namespace

TEST(UpsettingInSpace, ForceOfALinearHardeningBlock) {
  const double heights[] = {0.95, 0.9, 0.8}, rigid[] = {1.1066, 1.2282, 1.5289};
  for (int nodes : {4, 10}) {
    Block block(nodes);
    for (int k = 0; k < 3; ++k) {
      const double force = block.press(heights[k], 12), log = std::log(1 / heights[k]);
      EXPECT_NEAR(force / Y / rigid[k], 1, 1e-2);
      EXPECT_NEAR(force * heights[k] / (Y * (1 + log) / (1 + Y / E)), 1, 2e-4);
    }
    const Eigen::VectorXd ep = internal_field(block.body, "plastic_strain_eq");
    EXPECT_NEAR(ep.minCoeff(), ep.maxCoeff(), 1e-7);
    double volume = 0;
    for (int p = 0; p < ep.size(); ++p)
      volume += block.body.discretization().weight[p] *
                determinant(Gradient<3>(point_state(block.body.state(), p).F));
    EXPECT_NEAR(volume, 1, 2e-3) << "of the block, but for elastic strain";
  }
}
