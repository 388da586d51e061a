#include "material/corotational_rate.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {
namespace {

struct Named {
  const char* name;
  CorotationalRate rate;
};
constexpr Named NAMES[] = {{"jaumann", CorotationalRate::JAUMANN},
                           {"greennaghdi", CorotationalRate::GREEN_NAGHDI},
                           {"logarithmic", CorotationalRate::LOGARITHMIC}};

/// k(u) = (coth x - 1/x)/tanh x with tanh^2 x = u, and dk/du: even in x, so smooth in u = 0..1.
struct Langevin {
  double value, slope;
};

Langevin langevin(double u) {
  // its series, for u below SERIES, where the closed form loses digits
  constexpr double SERIES = 0.05;
  constexpr double COEFFICIENTS[] = {1. / 3,
                                     4. / 45,
                                     44. / 945,
                                     428. / 14175,
                                     10196. / 467775,
                                     10719068. / 638512875,
                                     25865068. / 1915538625,
                                     5472607916. / 488462349375,
                                     0.009516073194527899,
                                     0.008231206567350501};
  constexpr int TERMS = sizeof COEFFICIENTS / sizeof *COEFFICIENTS;
  if (u < SERIES) {
    Langevin k{0, 0};
    for (int n = TERMS - 1; n >= 0; --n) {
      k.slope = k.slope * u + k.value;
      k.value = k.value * u + COEFFICIENTS[n];
    }
    return k;
  }
  const double z = std::sqrt(u), x = std::atanh(z);
  const double ratio = z / x, ratio_by_z = (1 - ratio / (1 - u)) / x; // d(z/x)/dz, dx/dz = 1/(1 - z^2)
  const double value = (1 - ratio) / u;
  return {value, (-ratio_by_z / (2 * z) - value) / u};
}

/// In-plane part of B = F F': mean of its eigenvalues, half difference of xx and yy, xy.
struct LeftTensor {
  explicit LeftTensor(const Gradient<2>& F)
      : middle(0.5 * (F[0] * F[0] + F[1] * F[1] + F[2] * F[2] + F[3] * F[3])),
        half(0.5 * (F[0] * F[0] + F[1] * F[1] - F[2] * F[2] - F[3] * F[3])),
        shear(F[0] * F[2] + F[1] * F[3]) {}
  double middle, half, shear;
};

} // namespace

CorotationalRate corotational_rate(const std::string& name, const char* where) {
  std::string known;
  for (const Named& entry : NAMES) {
    if (entry.name == name) return entry.rate;
    known += (known.empty() ? "\"" : ", \"") + std::string(entry.name) + "\"";
  }
  fail(where, "unknown rate \"" + name + "\", expected one of " + known);
}

PlaneRotation polar_rotation(const Gradient<2>& F_old, const Gradient<2>& F) {
  const double a_old = F_old[0] + F_old[3], b_old = F_old[2] - F_old[1];
  const double a = F[0] + F[3], b = F[2] - F[1];
  const double size = 1 / std::sqrt((a * a + b * b) * (a_old * a_old + b_old * b_old));
  return {size * (a * a_old + b * b_old), size * (b * a_old - a * b_old)};
}

AngleByF polar_angle_by_F(const Gradient<2>& F) {
  const double a = F[0] + F[3], b = F[2] - F[1], size = 1 / (a * a + b * b);
  AngleByF by_F;
  by_F << -b * size, -a * size, a * size, -b * size, 0;
  return by_F;
}

double logarithmic_excess(const Gradient<2>& F, const Stress<2>& d) {
  const LeftTensor B(F);
  const double u = (B.half * B.half + B.shear * B.shear) / (B.middle * B.middle);
  return langevin(u).value * (d[3] * B.half - 0.5 * (d[0] - d[1]) * B.shear) / B.middle;
}

AngleByF logarithmic_excess_by_F(const Gradient<2>& F, const Stress<2>& d, const StrainByF& d_by_F,
                                 double share) {
  const LeftTensor B(F);
  const double u = (B.half * B.half + B.shear * B.shear) / (B.middle * B.middle);
  const Langevin k = langevin(u);
  const double turn = d[3] * B.half - 0.5 * (d[0] - d[1]) * B.shear;
  AngleByF middle_by, half_by, shear_by;
  middle_by << F[0], F[1], F[2], F[3], 0;
  half_by << F[0], F[1], -F[2], -F[3], 0;
  shear_by << F[2], F[3], F[0], F[1], 0;
  const AngleByF u_by =
      2 / (B.middle * B.middle) * (B.half * half_by + B.shear * shear_by - u * B.middle * middle_by);
  const AngleByF turn_by = d[3] * half_by - 0.5 * (d[0] - d[1]) * shear_by;
  const AngleByF at_fixed_F = B.half * d_by_F.row(3) - 0.5 * B.shear * (d_by_F.row(0) - d_by_F.row(1));
  return k.value / B.middle * (share * turn_by + at_fixed_F) +
         share * turn / B.middle * (k.slope * u_by - k.value / B.middle * middle_by);
}

} // namespace burnish
