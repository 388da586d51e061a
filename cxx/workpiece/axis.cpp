#include "workpiece/axis.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// A node counts as on the axis within this fraction of the largest coordinate: rounding of mesh files.
constexpr double AXIS_ROUNDING = 1e-9;

} // namespace

template <int Dim> AxisNodes<Dim>::AxisNodes(const Mesh<Dim>& mesh) {
  if (!mesh.axisymmetric) return;
  for (const double x : mesh.X) m_rounding = std::max(m_rounding, AXIS_ROUNDING * std::abs(x));
  for (int a = 0; a < mesh.num_nodes; ++a)
    if (mesh.node(a)[0] <= m_rounding) m_nodes.push_back(a);
}

template <int Dim> void AxisNodes<Dim>::check(const Eigen::VectorXd& displacement, const char* where) const {
  for (const int a : m_nodes) {
    if (!(std::abs(displacement[Dim * a]) > m_rounding)) continue;
    std::ostringstream what;
    what << "radial displacement of node " << a << " on the axis = " << displacement[Dim * a]
         << ", expected 0: constrain it there, on(axis, u=0)";
    fail(where, what.str());
  }
}

template class AxisNodes<2>;
template class AxisNodes<3>;

} // namespace burnish
