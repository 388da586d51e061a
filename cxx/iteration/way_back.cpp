#include "iteration/way_back.hpp"
#include <algorithm>
#include <utility>

namespace burnish {
namespace {

constexpr double TOO_FAR =
    0.8; // slope beyond the minimum over that at the start, from which the iterate goes back
constexpr double CAREFUL = 0.5;     // the same where the residual has grown in the step
constexpr double LEAST_SHARE = 0.1; // of the increment so far that a way back leaves
constexpr int MAX_WAYS = 5;         // along an increment

double slope(const Eigen::VectorXd& du, const Eigen::VectorXd& R, const std::vector<char>& counted) {
  double sum = 0;
  for (Eigen::Index d = 0; d < du.size(); ++d)
    if (counted[d]) sum += du[d] * R[d];
  return sum;
}

} // namespace

void WayBack::leave(Iterate start) {
  *this = WayBack();
  m_start = std::move(start);
}

// The increment, as it was before the first way back. Returns whether another may follow.
bool WayBack::measure(const Eigen::VectorXd& u, const Eigen::VectorXd& q, int most) {
  if (m_start.u.size() != u.size() || m_made >= most) return false;
  if (m_made == 0) {
    m_du = u - m_start.u;
    m_dq = q - m_start.q;
  }
  return true;
}

bool WayBack::go_back(Eigen::VectorXd& u, Eigen::VectorXd& q, const Eigen::VectorXd& R,
                      const std::vector<char>& counted, bool careful) {
  if (!measure(u, q, MAX_WAYS)) return false;
  const double there = slope(m_du, m_start.R, counted), here = slope(m_du, R, counted);
  if (!(there < 0 && here > -(careful ? CAREFUL : TOO_FAR) * there)) return false;
  return keep(m_share * std::max(LEAST_SHARE, there / (there - here)), u, q);
}

bool WayBack::go_half(Eigen::VectorXd& u, Eigen::VectorXd& q) { return measure(u, q, 1) && keep(0.5, u, q); }

bool WayBack::keep(double share, Eigen::VectorXd& u, Eigen::VectorXd& q) {
  ++m_made;
  m_share = share;
  u = m_start.u + m_share * m_du;
  q = m_start.q + m_share * m_dq;
  return true;
}

template <int Dim>
std::vector<char> free_of_contact(const BodyView<Dim>& body, const std::vector<int>& candidates,
                                  const ContactState<Dim>& state) {
  std::vector<char> flags(body.fixed.size());
  for (std::size_t d = 0; d < flags.size(); ++d) flags[d] = !body.fixed[d];
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    if (in_contact(state.nodes[i].state)) std::fill_n(flags.begin() + Dim * candidates[i], Dim, 0);
  return flags;
}

template std::vector<char> free_of_contact<2>(const BodyView<2>&, const std::vector<int>&,
                                              const ContactState<2>&);
template std::vector<char> free_of_contact<3>(const BodyView<3>&, const std::vector<int>&,
                                              const ContactState<3>&);

} // namespace burnish
