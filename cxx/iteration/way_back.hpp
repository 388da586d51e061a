#pragma once
// The way back of an iterate that went too far: a line search on the work of the out-of-balance forces (ALGORITHMS.md 5.6).
#include "contact/body_view.hpp"
#include "contact/contact_state.hpp"
#include <vector>

namespace burnish {

/// An iterate and the out-of-balance nodal forces there.
struct Iterate {
  Eigen::VectorXd u, q, R; ///< displacement [length], coordinates, internal minus external forces [force]
};

class WayBack {
public:
  /// A step begins: no increment has been made.
  void begin() { *this = WayBack(); }
  /// An increment begins at an iterate.
  void leave(Iterate start);
  const Iterate& start() const {
    return m_start;
  }                                   ///< where the last increment began; u empty before the first
  int made() const { return m_made; } ///< ways back along the last increment so far

  /// In the plane, where states adapt: looks at the iterate that the increment has led to, and moves it back to where the work of the out-of-balance
  /// forces along the increment has its minimum, ALGORITHMS.md (5.5), if it is far beyond: s = du . R over `counted`, at the start negative.
  /// @param u, q the iterate @param R its out-of-balance forces @param counted degrees of freedom whose forces shall vanish
  /// @param careful the residual has grown in this step: a shorter way beyond the minimum is too far
  /// @returns whether it was moved
  bool go_back(Eigen::VectorXd& u, Eigen::VectorXd& q, const Eigen::VectorXd& R,
               const std::vector<char>& counted, bool careful);
  /// In event pieces and in space: half of the increment, once. @returns whether it was moved
  bool go_half(Eigen::VectorXd& u, Eigen::VectorXd& q);

private:
  bool measure(const Eigen::VectorXd& u, const Eigen::VectorXd& q, int most);
  bool keep(double share, Eigen::VectorXd& u, Eigen::VectorXd& q);

  Iterate m_start;
  Eigen::VectorXd m_du, m_dq; // the whole increment
  double m_share = 1;         // of it that is left
  int m_made = 0;
};

/// Degrees of freedom that are neither given nor of nodes in contact, whose forces the contact takes. @returns a flag each
template <int Dim>
std::vector<char> free_of_contact(const BodyView<Dim>& body, const std::vector<int>& candidates,
                                  const ContactState<Dim>& state);

} // namespace burnish
