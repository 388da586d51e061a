#include "material/corotational_rate.hpp"
#include "base/error.hpp"
#include "material/langevin.hpp"
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
