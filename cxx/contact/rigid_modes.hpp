#pragma once
// Displacements of the workpiece's nodes by its rigid motions.
#include "contact/body_view.hpp"

namespace burnish {

/// Translations, then turns about a center, those over the size of the body: all are displacements [length].
template <int Dim> class RigidModes {
public:
  static constexpr int count = Dim + Dim * (Dim - 1) / 2;
  using Motion = Eigen::Matrix<double, Dim, count>;
  using Form = Eigen::Matrix<double, count, count>;

  RigidModes(const BodyView<Dim>& body, const Vector<Dim>& center) : m_center(center) {
    const auto X = body.X.reshaped(Dim, body.X.size() / Dim);
    m_size = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).norm();
  }

  /// Displacement of the place x by each of them.
  Motion operator()(const Vector<Dim>& x) const {
    Motion m = Motion::Zero();
    m.template leftCols<Dim>().setIdentity();
    const Vector<Dim> r = (x - m_center) / m_size;
    int turn = Dim;
    for (int a = 0; a < Dim; ++a)
      for (int b = a + 1; b < Dim; ++b, ++turn) {
        m(a, turn) = -r[b];
        m(b, turn) = r[a];
      }
    return m;
  }

  /// Sum of the squares of what they displace the supported components by.
  Form resisted_by_supports(const BodyView<Dim>& body, const Eigen::VectorXd& u) const {
    Form resisted = Form::Zero();
    for (Eigen::Index a = 0; a < body.X.size() / Dim; ++a) {
      const Motion m = (*this)(body.position(u, static_cast<int>(a)));
      for (int c = 0; c < Dim; ++c)
        if (body.fixed[Dim * a + c]) resisted += m.row(c).transpose() * m.row(c);
    }
    return resisted;
  }

private:
  Vector<Dim> m_center;
  double m_size;
};

} // namespace burnish
