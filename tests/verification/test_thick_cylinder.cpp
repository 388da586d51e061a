// Elastic thick-walled cylinder under inner pressure, its ends held along the axis (Lame): with radii a, b
//   u_r = c ((1 - 2 nu) r + b^2/r), c = p a^2 (1 + nu)/(E (b^2 - a^2)),
//   s_rr = k (1 - b^2/r^2), s_hoop = k (1 + b^2/r^2), s_zz = 2 nu k, k = p a^2/(b^2 - a^2).
// The pressure acts as nodal forces of the whole ring, 2 pi a p times the integral of N_a. Orders in L2 for
// elements of degree k: displacement k + 1, stress k.
#include "material/j2/law.hpp"
#include "support/equilibrium.hpp"
#include "support/structured_mesh.hpp"
#include <iostream>

using namespace burnish;
using namespace burnish::test;

namespace {

const double INNER = 1, OUTER = 2, HEIGHT = 0.5, E = 210, NU = 0.3, PRESSURE = 1;
const double LOAD = PRESSURE * INNER * INNER / (OUTER * OUTER - INNER * INNER);

double exact_displacement(double r) { return LOAD * (1 + NU) / E * ((1 - 2 * NU) * r + OUTER * OUTER / r); }
Stress<2> exact_stress(double r) {
  const double square = OUTER * OUTER / (r * r);
  return LOAD * Stress<2>(1 - square, 0, 1 + square, 0) + Stress<2>(0, 2 * NU * LOAD, 0, 0);
}

/// n x n/2 cells, moved so that no two are alike.
Discretization<2> wall(int n, int order) {
  const ContactMesh plane = structured_mesh(n, n / 2, order, [](double xi, double eta) {
    const double bump = 0.04 * std::sin(M_PI * xi) * std::sin(M_PI * eta);
    return Vector<2>(INNER + (OUTER - INNER) * xi + bump * std::cos(2 * xi + eta), HEIGHT * eta + bump * xi);
  });
  return triangles(plane.space.nodes_per_element, plane.space.X, plane.space.connectivity, true);
}

struct Errors {
  double displacement, stress; // L2 over the ring, relative
};

/// Linear elasticity: the tangent of the undeformed body, and the stress of a displacement scaled down.
Errors solve(int n, int order) {
  Workpiece<2> body(wall(n, order), j2_law<2>(J2Parameters::from_young(E, NU, 1e3 * E, 0)));
  const Discretization<2>& mesh = body.discretization();
  std::vector<char> held(mesh.num_dofs(), 0);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh.num_dofs());
  const double cells = n / 2;
  for (int a = 0; a < mesh.num_nodes; ++a) {
    const Vector<2> X = mesh.node(a);
    const bool end = X[1] < 1e-9 || X[1] > HEIGHT - 1e-9;
    held[2 * a + 1] = end;
    if (X[0] > INNER + 1e-9) continue;
    const double vertex = std::abs(X[1] / HEIGHT * cells - std::round(X[1] / HEIGHT * cells));
    const double share = order == 1 ? (end ? 0.5 : 1) : vertex > 0.1 ? 2. / 3 : (end ? 1. / 6 : 1. / 3);
    load[2 * a] = 2 * M_PI * INNER * PRESSURE * HEIGHT / cells * share;
  }
  NodeBlockMatrix<2> K = body.pattern();
  body.tangent(K, TangentKind::ELASTIC);
  const Eigen::VectorXd u = correction(K, -load, held);
  const double small = 1e-6;
  EXPECT_EQ(body.update(small * u, 1, 0).status, UpdateStatus::OK);
  double du = 0, u2 = 0, ds = 0, s2 = 0;
  for (int p = 0; p < mesh.num_points(); ++p) {
    const double r = mesh.point[2 * p], exact = exact_displacement(r);
    Vector<2> at = Vector<2>::Zero();
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      at += mesh.shapes(p)[a] * u.segment<2>(2 * mesh.element(p / mesh.points_per_element)[a]);
    du += mesh.weight[p] * (at - Vector<2>(exact, 0)).squaredNorm();
    u2 += mesh.weight[p] * exact * exact;
    const Stress<2> stress = Eigen::Map<const Stress<2>>(&body.state().stress[4 * p]) / small;
    ds += mesh.weight[p] * (stress - exact_stress(r)).squaredNorm();
    s2 += mesh.weight[p] * exact_stress(r).squaredNorm();
  }
  return {std::sqrt(du / u2), std::sqrt(ds / s2)};
}

void check(int order, const std::vector<int>& cells, double displacement_at_last, double stress_at_last) {
  Errors before{};
  for (const int n : cells) {
    const Errors now = solve(n, order);
    const double u_order = std::log2(before.displacement / now.displacement),
                 s_order = std::log2(before.stress / now.stress);
    std::cout << "P" << order << ", " << n << " cells through the wall: displacement " << now.displacement
              << ", stress " << now.stress;
    if (n != cells.front()) {
      std::cout << "; orders " << u_order << ", " << s_order;
      EXPECT_NEAR(u_order, order + 1, 0.15);
      EXPECT_NEAR(s_order, order, 0.15);
    }
    std::cout << "\n";
    before = now;
  }
  EXPECT_LE(before.displacement, displacement_at_last);
  EXPECT_LE(before.stress, stress_at_last);
}

} // namespace

TEST(ThickCylinder, OrderOfP1) { check(1, {8, 16, 32}, 1e-4, 4e-3); }
TEST(ThickCylinder, OrderOfP2) { check(2, {8, 16, 32}, 1e-6, 1e-4); }
