#pragma once
// Nodal forces of quadratic facets shared to their vertices, and the tractions that follow (METHOD.md 3.20).
#include "contact/tributary_area.hpp"

namespace burnish {

/// Share of the tributary area of a mid node beside it from which a vertex of quadratic facets has one of its own. In the plane
/// it is 1/4 or more; on the axis 0, and nearer to the axis than a third of its edge small: its force there is the difference
/// of two effects, the pressure and its slope.
inline constexpr double OWN_AREA = 0.1;

/// Corners are the vertices in contact, those without an area of their own, which have no force to be in contact by, and the ends of a mid node that touches alone. A mid node gives half of its force to both ends of its edge, all of it
/// to the one that is a corner. Where both ends are corners the shares are the integrals of the traction with the linear
/// functions of the vertices, whatever the traction, in the plane and over rings.
template <int Dim> class CornerShares {
public:
  /// @param area tributary areas of the candidates
  CornerShares(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
               const std::vector<Facet<Dim>>& facets, const Eigen::VectorXd& u, const Eigen::VectorXd& area);
  bool empty() const { return m_corners.empty(); }
  /// Candidates that are corners.
  const std::vector<int>& corners() const { return m_corners; }
  /// Integral of the linear function of each corner over its facets [length or area]. Beside a vertex that is no candidate
  /// it is 1 on the whole edge.
  const Eigen::VectorXd& areas() const { return m_areas; }
  /// Shares of the corners, one each. @param force one number per candidate [force]
  Eigen::VectorXd shared(const Eigen::VectorXd& force) const;
  /// Tractions of the candidates, linear on every facet: share over area at corners, means of their ends at mid nodes, zero
  /// at other vertices of these facets; `nodal` stays elsewhere. Their integral is the sum of the forces.
  /// @param force nodal forces [force]; @param nodal [stress]
  Eigen::VectorXd traction(const Eigen::VectorXd& force, Eigen::VectorXd nodal) const;

private:
  struct Middle {
    int node;
    std::array<int, 2> end;       // candidates, -1: none
    std::array<double, 2> weight; // of its force
  };
  void find_small(const Eigen::VectorXd& area);
  void choose_corners(const ContactState<Dim>& state);
  void find_middles(const std::vector<std::vector<int>>& facets);

  std::vector<int> m_corners, m_number; // candidates; per candidate its place among them, -1: none
  Eigen::VectorXd m_areas;
  std::vector<Middle> m_middles; // of quadratic facets
  std::vector<char> m_small;     // per candidate: a vertex without an area of its own
  std::vector<char> m_reported;  // per candidate: a node of a facet with a corner
};

} // namespace burnish
