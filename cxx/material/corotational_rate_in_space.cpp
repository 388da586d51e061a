#include "material/corotational_rate_in_space.hpp"
#include "base/cross_matrix.hpp"
#include "material/langevin.hpp"

namespace burnish {
namespace {

using Svd = Eigen::JacobiSVD<Tensor<3>>;
Svd svd_of(const Gradient<3>& F) { return Svd(mesh_part<3>(F), Eigen::ComputeFullU | Eigen::ComputeFullV); }

// -(coth x - 1/x) with x = (ln a - ln b)/2, and its derivative by a.
struct SpinFactor {
  double value, by_first;
};
SpinFactor spin_factor(double a, double b) {
  const double z = (a - b) / (a + b);
  const Langevin k = langevin(z * z);
  return {-k.value * z, -(k.value + 2 * z * z * k.slope) * 2 * b / ((a + b) * (a + b))};
}

// (f(a, c) - f(b, c))/(a - b) of the spin factor f.
double divided_difference(double a, double b, double c) {
  constexpr double CLOSE = 1e-4; // below, the derivative in the middle has the smaller error
  if (std::abs(a - b) <= CLOSE * (a + b)) return spin_factor(0.5 * (a + b), c).by_first;
  return (spin_factor(a, c).value - spin_factor(b, c).value) / (a - b);
}

/// Principal axes of F F', and there the excess of a strain and its derivative.
class Principal {
public:
  Principal(const Gradient<3>& F, const Stress<3>& d) {
    const Tensor<3> B = mesh_part<3>(F) * mesh_part<3>(F).transpose();
    const Eigen::SelfAdjointEigenSolver<Tensor<3>> solver(B);
    m_axes = solver.eigenvectors();
    m_b = solver.eigenvalues();
    m_d = into(matrix_of<3>(d));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m_factor(i, j) = i == j ? 0 : spin_factor(m_b[i], m_b[j]).value;
  }
  Tensor<3> into(const Tensor<3>& T) const { return m_axes.transpose() * T * m_axes; }
  Vector<3> out(const Tensor<3>& T) const { return axial_vector(m_axes * T * m_axes.transpose()); }
  Vector<3> excess() const { return out(m_factor.cwiseProduct(m_d)); }
  void prepare_change() {
    for (int i = 0; i < 3; ++i)
      for (int m = 0; m < 3; ++m)
        for (int j = 0; j < 3; ++j) m_difference[i](m, j) = divided_difference(m_b[i], m_b[m], m_b[j]);
  }
  /// For a change of B and of d, both in the principal axes: f is odd under the exchange of its arguments.
  Vector<3> change(const Tensor<3>& dB, const Tensor<3>& dd) const {
    Tensor<3> T = m_factor.cwiseProduct(dd);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int m = 0; m < 3; ++m)
          T(i, j) +=
              m_difference[i](m, j) * dB(i, m) * m_d(m, j) - m_difference[j](m, i) * m_d(i, m) * dB(m, j);
    return out(T);
  }

private:
  Tensor<3> m_axes, m_d, m_factor;
  Vector<3> m_b;
  Tensor<3> m_difference[3];
};

} // namespace

Tensor<3> polar_rotation(const Gradient<3>& F) {
  const Svd svd = svd_of(F);
  return svd.matrixU() * svd.matrixV().transpose();
}

SpinByF3 polar_spin_by_F(const Gradient<3>& F) {
  const Svd svd = svd_of(F);
  const Tensor<3>& W = svd.matrixU();
  const Tensor<3> R = W * svd.matrixV().transpose();
  const Vector<3> rest = svd.singularValues().sum() - svd.singularValues().array(); // of tr(V) I - V
  const Tensor<3> inverse = W * rest.cwiseInverse().asDiagonal() * W.transpose();
  SpinByF3 by_F;
  for (int k = 0; k < 3; ++k)
    for (int L = 0; L < 3; ++L) {
      const Tensor<3> dF_R = Vector<3>::Unit(k) * R.col(L).transpose();
      by_F.col(3 * k + L) = 2 * inverse * axial_vector(dF_R);
    }
  return by_F;
}

Vector<3> logarithmic_excess(const Gradient<3>& F, const Stress<3>& d) { return Principal(F, d).excess(); }

SpinByF3 logarithmic_excess_by_F(const Gradient<3>& F, const Stress<3>& d, const StrainByF3& d_by_F,
                                 double share) {
  Principal at(F, d);
  at.prepare_change();
  SpinByF3 by_F;
  for (int k = 0; k < 3; ++k)
    for (int L = 0; L < 3; ++L) {
      const Tensor<3> half = Vector<3>::Unit(k) * mesh_part<3>(F).col(L).transpose(); // dF F'
      const int c = 3 * k + L;
      by_F.col(c) = at.change(share * at.into(half + half.transpose()),
                              at.into(matrix_of<3>(Stress<3>(d_by_F.col(c)))));
    }
  return by_F;
}

Tensor<3> rotation_vector_tangent(const Vector<3>& v) {
  const double t = v.squaredNorm(), angle = std::sqrt(t), half = 0.5 * angle;
  const bool small = t < 0.01;
  const double first = small ? 0.5 - t / 24 + t * t / 720 - t * t * t / 40320
                             : 2 * std::sin(half) * std::sin(half) / t; // (1 - cos)/angle^2
  const double second =
      small ? 1. / 6 - t / 120 + t * t / 5040 - t * t * t / 362880 : (angle - std::sin(angle)) / (t * angle);
  const Tensor<3> H = cross_matrix(v);
  return Tensor<3>::Identity() + first * H + second * H * H;
}

} // namespace burnish
