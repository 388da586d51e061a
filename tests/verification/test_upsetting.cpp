// Frictionless upsetting to half the height, J2 with linear hardening, as a homogeneous deformation of a
// distorted mesh: bottom held, top moved down, sides free, ends frictionless. Force against L = ln(h0/h).
//
// Cylinder. One stress, tau < 0 along the axis; elastic and plastic strain add up in the logarithms:
//   L = ep + |tau|/E, |tau| = Y + H ep, so |tau| = (Y + H L)/(1 + H/E), and with P = tau/F_axial exactly
//   F = (Y + H L)/(1 + H/E) A0 h0/h, A0 = pi R^2;   METHOD.md 8, C18, is the limit H/E -> 0.
//
// Block in plane strain, rigid-plastic limit. No stress across (xx), no strain out of the plane (zz): flow
// along the deviator makes s_zz = 0, so tau_zz = tau_yy/2 and
//   s = tau_yy (-1/2, 1/2, 0), q = sqrt(3/2 s:s) = sqrt(3)/2 |tau_yy|,
//   ep' = sqrt(2/3 d:d) = sqrt(2/3 (d_yy^2 + d_xx^2)) = 2/sqrt(3) |d_yy|, so ep = (2/sqrt(3)) L,
//   F = (2/sqrt(3)) (Y + (2/sqrt(3)) H L) w0 h0/h per unit of thickness; elastic strain changes it by O(Y/E).
#include "material/j2/law.hpp"
#include "support/equilibrium.hpp"
#include "support/structured_mesh.hpp"
#include "workpiece/point_fields.hpp"
#include <iostream>

using namespace burnish;
using namespace burnish::test;

namespace {

const double WIDTH = 0.6, HEIGHT = 1, Y = 200, END = 0.5; // radius or width; end height
const double LOG = std::log(HEIGHT / END), AREA_RATIO = HEIGHT / END;

struct Upsetting {
  Workpiece<2> body;
  std::vector<char> held;
  Eigen::VectorXd u;
  Upsetting(bool axisymmetric, int order, double E, double H)
      : body(mesh(axisymmetric, order), j2_law<2>(J2Parameters::from_young(E, 0.3, Y, H))),
        u(Eigen::VectorXd::Zero(body.discretization().num_dofs())) {
    const Discretization<2>& d = body.discretization();
    held.assign(d.num_dofs(), 0);
    for (int a = 0; a < d.num_nodes; ++a) {
      held[2 * a] = d.node(a)[0] < 1e-9; // axis, or plane of symmetry
      held[2 * a + 1] = d.node(a)[1] < 1e-9 || d.node(a)[1] > HEIGHT - 1e-9;
    }
  }
  static Discretization<2> mesh(bool axisymmetric, int order) {
    const ContactMesh plane = structured_mesh(3, 4, order, [](double xi, double eta) {
      const double bump = 0.08 * std::sin(M_PI * xi) * std::sin(M_PI * eta);
      return Vector<2>(WIDTH * xi + bump, HEIGHT * eta - 0.7 * bump);
    });
    return triangles(plane.space.nodes_per_element, plane.space.X, plane.space.connectivity, axisymmetric);
  }
  /// @return force on the upper end after n steps equal in the logarithm, positive in compression
  double force(int n) {
    const Discretization<2>& d = body.discretization();
    const double side = d.axisymmetric ? -0.5 : -1; // incompressible: where the iteration starts
    for (int k = 1; k <= n; ++k) {
      const double height = std::exp(-LOG * k / n), width = std::pow(height, side);
      for (int a = 0; a < d.num_nodes; ++a) {
        u[2 * a] = (width - 1) * d.node(a)[0];
        u[2 * a + 1] = (height - 1) * d.node(a)[1];
      }
      equilibrate(body, held, u);
      if (testing::Test::HasFatalFailure()) return 0;
      body.accept();
    }
    double sum = 0;
    const Eigen::VectorXd R = body.internal_force();
    for (int a = 0; a < d.num_nodes; ++a)
      if (d.node(a)[1] > HEIGHT - 1e-9) sum -= R[2 * a + 1];
    return sum;
  }
};

double cylinder(double E, double H) {
  return (Y + H * LOG) / (1 + H / E) * M_PI * WIDTH * WIDTH * AREA_RATIO;
}
double block(double H) {
  const double factor = 2 / std::sqrt(3.0);
  return factor * (Y + factor * H * LOG) * WIDTH * AREA_RATIO;
}

} // namespace

TEST(Upsetting, CylinderSecondOrderInTheStep) {
  const double E = 2e5, H = 1000;
  for (int order : {1, 2}) {
    double before = 0;
    for (int n : {10, 20, 40}) {
      const double error = Upsetting(true, order, E, H).force(n) / cylinder(E, H) - 1;
      std::cout << "P" << order << ", " << n << " steps: force off by " << error << "\n";
      if (before != 0) {
        EXPECT_NEAR(std::log2(before / error), 2, 0.1);
      }
      before = error;
    }
    EXPECT_LE(std::abs(before), 1e-4);
  }
}

TEST(Upsetting, CylinderWithoutElasticity) { // the formula above: off by H/E
  for (double H : {0., 200.}) {
    const double E = 2e6, c18 = cylinder(1e99, H);
    EXPECT_NEAR(Upsetting(true, 2, E, H).force(80) / c18, 1 - H / E, 2e-5) << "H = " << H;
  }
}

TEST(Upsetting, BlockInPlaneStrainTendsToTheRigidPlasticForce) {
  const double H = 200;
  for (int order : {1, 2}) {
    double before = 0;
    for (double E : {1e5, 2e5, 4e5}) {
      const double error = Upsetting(false, order, E, H).force(80) / block(H) - 1;
      std::cout << "P" << order << ", E/Y " << E / Y << ": force off by " << error << "\n";
      EXPECT_LE(std::abs(error), 5 * Y / E);
      if (before != 0) {
        EXPECT_NEAR(std::log2(before / error), 1, 0.1);
      }
      before = error;
    }
  }
}

TEST(Upsetting, StressAndStrainAreHomogeneous) {
  for (bool axisymmetric : {true, false}) {
    Upsetting upsetting(axisymmetric, 2, 2e5, 1000);
    upsetting.force(20);
    const WorkpieceState<2>& state = upsetting.body.state();
    const Eigen::VectorXd plastic_strain_eq = internal_field(upsetting.body, "plastic_strain_eq");
    const double rate = axisymmetric ? 1 : 2 / std::sqrt(3.0);
    EXPECT_NEAR(plastic_strain_eq[0], rate * LOG, 1e-2);
    for (int p = 0; p < plastic_strain_eq.size(); ++p) {
      EXPECT_NEAR(plastic_strain_eq[p], plastic_strain_eq[0], 1e-8);
      const double* stress = &state.stress[4 * p];
      EXPECT_NEAR(stress[0], 0, 1e-5 * Y); // across
      EXPECT_NEAR(stress[2] / stress[1], axisymmetric ? 0 : 0.5, axisymmetric ? 1e-8 : 1e-3);
    }
  }
}
