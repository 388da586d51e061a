// The window of candidates that the factor keeps, and the shift that holds a floating body.
#include "stepping/corrector.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {

// Tangent of a body that only its tools hold, with stiffness on the diagonal of the contact nodes and of both
// ends of the window; the dense block takes it off again (ContactBlockInput::shift).
template <int Dim> const NodeBlockMatrix<Dim>& Corrector<Dim>::shifted(const NodeBlockMatrix<Dim>& K) {
  m_shifted = K;
  m_shift = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(m_window.size()));
  for (std::size_t w = 0; w < m_window.size(); ++w) {
    const bool end = w == 0 || w + 1 == m_window.size();
    if (!end && !in_contact(m_state.nodes[m_window[w]].state)) continue;
    const int node = m_model.candidates[m_window[w]];
    double* block = m_shifted.block(m_shifted.find(node, node));
    for (int c = 0; c < Dim; ++c) {
      if (m_body.fixed[Dim * node + c]) continue;
      const double stiffness = std::abs(block[c * Dim + c]);
      m_shift[Dim * static_cast<Eigen::Index>(w) + c] = stiffness;
      block[c * Dim + c] += stiffness;
    }
  }
  return m_shifted;
}

template <int Dim> double Corrector<Dim>::contact_width(const Eigen::VectorXd& u, int tool) const {
  double width = 0;
  std::vector<Vector<Dim>> x;
  for (std::size_t i = 0; i < m_state.nodes.size(); ++i)
    if (in_contact(m_state.nodes[i].state) && m_state.nodes[i].tool == tool)
      x.push_back(m_body.position(u, m_model.candidates[i]));
  for (const auto& a : x)
    for (const auto& b : x) width = std::max(width, (a - b).norm());
  return width;
}

// Candidates near a contact node, or near the closest free node when nothing is in contact.
template <int Dim>
std::vector<int> Corrector<Dim>::near_contact(const Eigen::VectorXd& u, double widths,
                                              double spacings) const {
  std::vector<char> chosen(m_state.nodes.size(), 0);
  const auto poses = m_model.poses(m_state.q);
  for (std::size_t t = 0; t < m_model.tools.size(); ++t) {
    std::vector<Vector<Dim>> centers;
    double best = std::numeric_limits<double>::infinity();
    Vector<Dim> closest = Vector<Dim>::Zero();
    for (std::size_t i = 0; i < m_state.nodes.size(); ++i) {
      const Vector<Dim> x = m_body.position(u, m_model.candidates[i]);
      if (in_contact(m_state.nodes[i].state)) {
        if (m_state.nodes[i].tool == static_cast<int>(t)) centers.push_back(x);
        continue;
      }
      if (!m_model.may_touch(static_cast<int>(i), static_cast<int>(t))) continue;
      const double gap = m_model.tools[t]->closest_point(poses[t], x, m_state.nodes[i].s).gap;
      if (gap < best) {
        best = gap;
        closest = x;
      }
      if (gap < m_options.gap_tolerance * m_body.spacing) chosen[i] = 1;
    }
    if (centers.empty() && std::isfinite(best)) centers.push_back(closest);
    const double reach = widths * contact_width(u, static_cast<int>(t)) + spacings * m_body.spacing;
    for (std::size_t i = 0; i < m_state.nodes.size(); ++i) {
      if (chosen[i]) continue;
      const Vector<Dim> x = m_body.position(u, m_model.candidates[i]);
      for (const auto& c : centers)
        if ((x - c).squaredNorm() <= reach * reach) {
          chosen[i] = 1;
          break;
        }
    }
  }
  std::vector<int> list;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i]) list.push_back(static_cast<int>(i));
  return list;
}

template <int Dim> bool Corrector<Dim>::window_covers(const Eigen::VectorXd& u) const {
  const std::vector<int> needed = near_contact(u, 0.3 * m_options.window_width, 0.3 * m_options.window_nodes);
  return std::includes(m_window.begin(), m_window.end(), needed.begin(), needed.end());
}

template <int Dim> void Corrector<Dim>::choose_window(const Eigen::VectorXd& u) {
  m_window = near_contact(u, m_options.window_width, m_options.window_nodes);
}

template <int Dim> Eigen::VectorXd Corrector<Dim>::on_window(const Eigen::VectorXd& full) const {
  Eigen::VectorXd part(Dim * static_cast<Eigen::Index>(m_window.size()));
  for (std::size_t w = 0; w < m_window.size(); ++w)
    part.template segment<Dim>(Dim * w) = full.template segment<Dim>(Dim * m_model.candidates[m_window[w]]);
  return part;
}

template <int Dim> Eigen::VectorXd Corrector<Dim>::scatter_window(const Eigen::VectorXd& window) const {
  Eigen::VectorXd full = Eigen::VectorXd::Zero(m_body.X.size());
  for (std::size_t w = 0; w < m_window.size(); ++w)
    full.template segment<Dim>(Dim * m_model.candidates[m_window[w]]) +=
        window.template segment<Dim>(Dim * w);
  return full;
}

// members of this file; corrector.cpp instantiates the others
template const NodeBlockMatrix<2>& Corrector<2>::shifted(const NodeBlockMatrix<2>&);
template double Corrector<2>::contact_width(const Eigen::VectorXd&, int) const;
template std::vector<int> Corrector<2>::near_contact(const Eigen::VectorXd&, double, double) const;
template bool Corrector<2>::window_covers(const Eigen::VectorXd&) const;
template void Corrector<2>::choose_window(const Eigen::VectorXd&);
template Eigen::VectorXd Corrector<2>::on_window(const Eigen::VectorXd&) const;
template Eigen::VectorXd Corrector<2>::scatter_window(const Eigen::VectorXd&) const;

} // namespace burnish
