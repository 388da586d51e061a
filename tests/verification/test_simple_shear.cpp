// S1: elastic simple shear with the Jaumann rate of the Kirchhoff stress,
//   s12 = G sin(gamma), s11 = -s22 = G (1 - cos(gamma)),
// which oscillates: the known defect of the rate. From u = gamma y: d_12 = gamma'/2, w_12 = gamma'/2, so
// s11' = gamma' s12, s12' = gamma' (G - s11).
#include "unit/workpiece/patch.hpp"
#include <cmath>
#include <complex>
#include <gtest/gtest.h>

using namespace burnish;
using namespace burnish::test;

namespace {

const double G = 2.7e10, GAMMA = 2.5; // beyond the top of s12

/// Largest error of s11 + i s12 over all points after n equal steps, relative to G.
double error_after(int nodes_per_element, StressUpdate update, StrainFrame frame, int n) {
  UpdateOptions options;
  options.update = update;
  options.strain_frame = frame;
  Workpiece<2> body(patch(nodes_per_element, 0.01), j2_law<2>(J2Parameters::from_shear(G, 0.32, 1e3 * G, 0)),
                    options);
  for (int k = 1; k <= n; ++k) {
    Tensor<2> F = Tensor<2>::Identity();
    F(0, 1) = GAMMA * k / n;
    EXPECT_EQ(body.update(homogeneous(body.discretization(), F), 1, 0).status, UpdateStatus::OK);
    body.accept();
  }
  const double s11 = G * (1 - std::cos(GAMMA)), s12 = G * std::sin(GAMMA);
  double error = 0;
  for (int p = 0; p < body.discretization().num_points(); ++p) {
    const Stress<2> stress = stress_at(body.state(), p);
    error = std::max(error, std::hypot(stress[0] - s11, stress[3] - s12));
  }
  return error / G;
}

void check(StrainFrame frame, double order, double error_of_100_steps) {
  for (int nodes : {3, 6})
    for (StressUpdate update :
         {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER}) {
      const double coarse = error_after(nodes, update, frame, 50),
                   fine = error_after(nodes, update, frame, 100);
      EXPECT_NEAR(std::log2(coarse / fine), order, 0.02)
          << "error with 50 steps " << coarse << ", with 100 " << fine;
      EXPECT_NEAR(fine / error_of_100_steps, 1, 0.05);
    }
}

} // namespace

// The discrete solution: with d = gamma/n, z = s11 + i s12 obeys z_new = exp(-i a) z + i G d exp(-i c),
// a = 4 atan(d/4), c = 0 in the midpoint frame and a/2 in the end frame, hence after n steps
//   z = G exp(i (a/2 - c)) (d/2)/sin(a/2) (1 - exp(-i n a)).

TEST(SimpleShear, JaumannOscillationMidpointFrameFirstOrder) { // error i d/2 (1 - exp(-i gamma)) G
  check(StrainFrame::MIDPOINT, 1, GAMMA / 100 * std::sin(GAMMA / 2));
}

TEST(SimpleShear, JaumannOscillationEndFrameSecondOrder) {
  // error d^2/16 (1 - exp(-i gamma)) - i gamma d^2/48 exp(-i gamma)
  const double d = GAMMA / 100;
  const std::complex<double> i(0, 1), turn = std::exp(-i * GAMMA);
  check(StrainFrame::END, 2, std::abs((1. - turn) / 16. - i * GAMMA * turn / 48.) * d * d);
}

TEST(SimpleShear, PressureAndOutOfPlaneStressStayZero) {
  Workpiece<2> body(patch(3, 1), j2_law<2>(J2Parameters::from_shear(G, 0.32, 1e3 * G, 0)));
  Tensor<2> F = Tensor<2>::Identity();
  for (double gamma : {0.5, 1.0, 1.5}) {
    F(0, 1) = gamma;
    body.update(homogeneous(body.discretization(), F), 1, 0);
    body.accept();
  }
  const Stress<2> stress = stress_at(body.state(), 0);
  EXPECT_NEAR(stress[0] + stress[1], 0, 1e-12 * G);
  EXPECT_NEAR(stress[2], 0, 1e-12 * G);
  EXPECT_GT(stress[0], 0.5 * G);
}
