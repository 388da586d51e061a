#include "run/hold.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

// Volume of an element with straight edges: per unit of thickness in the plane, of the whole ring if axisymmetric.
template <int Dim> double volume_of(const Mesh<Dim>& mesh, int element) {
  constexpr double factorial = Dim == 2 ? 2 : 6, pi = 3.14159265358979323846;
  const int* nodes = mesh.element(element);
  Tensor<Dim> edges;
  double radius = 0;
  for (int c = 0; c < Dim; ++c) edges.col(c) = mesh.node(nodes[c + 1]) - mesh.node(nodes[0]);
  for (int c = 0; c <= Dim; ++c) radius += mesh.node(nodes[c])[0] / (Dim + 1);
  return std::abs(edges.determinant()) / factorial * (mesh.axisymmetric ? 2 * pi * radius : 1);
}

} // namespace

template <int Dim> void Hold<Dim>::set(double stiffness, double until) {
  require(std::isfinite(stiffness) && stiffness > 0, "contact.hold", "stiffness", stiffness,
          "a finite number > 0");
  require(std::isfinite(until), "contact.hold", "until", until, "a finite number");
  m_state = HoldState{};
  m_state.stiffness = stiffness;
  m_state.until = until;
  measure();
}

template <int Dim> void Hold<Dim>::set_state(const HoldState& state) {
  m_state = state;
  if (state.stiffness > 0) measure();
}

// Every node of an element has the same part of its volume.
template <int Dim> void Hold<Dim>::measure() {
  m_volume = Eigen::VectorXd::Zero(m_mesh.num_nodes);
  for (int e = 0; e < m_mesh.num_elements; ++e)
    for (int a = 0; a < m_mesh.nodes_per_element; ++a)
      m_volume[m_mesh.element(e)[a]] += volume_of(m_mesh, e) / m_mesh.nodes_per_element;
}

template <int Dim> void Hold<Dim>::begin(double t, const Eigen::VectorXd& u) {
  if (m_state.stiffness == 0 || m_state.origin.size() > 0) return;
  require(m_state.until > t, "contact.hold", "until", m_state.until,
          ("later than the start of the step, " + std::to_string(t)).c_str());
  m_state.from = t;
  m_state.origin = u;
}

template <int Dim> double Hold<Dim>::factor(double t) const {
  if (m_state.stiffness == 0 || m_state.origin.size() == 0) return 0;
  const double left = (m_state.until - t) / (m_state.until - m_state.from);
  constexpr double rounding = 1e-9; // of the instant at which a step ends
  return left > rounding ? std::min(left, 1.) : 0;
}

template <int Dim> Eigen::VectorXd Hold<Dim>::force(const Eigen::VectorXd& u, double factor) const {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(u.size());
  if (!(factor > 0)) return f;
  for (Eigen::Index d = 0; d < u.size(); ++d)
    if (!m_body.fixed[d]) f[d] = -m_state.stiffness * factor * m_volume[d / Dim] * (u[d] - m_state.origin[d]);
  return f;
}

template <int Dim> void Hold<Dim>::add_force(const Eigen::VectorXd& u, double t, Eigen::VectorXd& R) const {
  if (acts(t)) R -= force(u, factor(t));
}

template <int Dim> void Hold<Dim>::add_stiffness(double t, NodeBlockMatrix<Dim>& K) const {
  if (!acts(t)) return;
  for (int node = 0; node < K.num_nodes; ++node) {
    double* block = K.block(K.find(node, node));
    for (int c = 0; c < Dim; ++c)
      if (!m_body.fixed[Dim * node + c]) block[c * Dim + c] += m_state.stiffness * factor(t) * m_volume[node];
  }
}

template <int Dim> double Hold<Dim>::carried(const Eigen::VectorXd& u, double t) const {
  if (!acts(t)) return 0;
  const Eigen::VectorXd f = force(u, factor(t));
  double sum = 0;
  for (Eigen::Index d = 0; d < f.size(); d += Dim) sum += f.template segment<Dim>(d).norm();
  return sum;
}

template <int Dim> void Hold<Dim>::accept(const Eigen::VectorXd& u, double t, double load) {
  m_state.factor = factor(t);
  if (!acts(t)) return;
  const double force = carried(u, t);
  m_state.share = force > 0 ? force / std::max(load, force) : 0;
}

template <int Dim> std::string Hold<Dim>::warning() const {
  if (m_state.stiffness == 0 || m_state.share <= NOTICED) return "";
  std::ostringstream text;
  if (m_state.factor > 0)
    text << "the hold, which ends at t = " << m_state.until << ", carries ";
  else
    text << "when the hold ended at t = " << m_state.until << " it still carried ";
  text << m_state.share << " of the load: tools and supports do not hold the workpiece alone";
  return text.str();
}

template class Hold<2>;
template class Hold<3>;

} // namespace burnish
