#pragma once
// Tractions that are linear on every quadratic facet in contact, fitted to nodal forces.
#include "contact/tributary_area.hpp"
#include <Eigen/Sparse>
#include <Eigen/SparseQR>

namespace burnish {

/// Unknown are the values at the vertices in contact; those of free vertices are zero, unless a vertex has no tributary
/// area and therefore no force of its own to be in contact by.
template <int Dim> class FacetFit {
public:
  /// @param area tributary areas of the candidates
  FacetFit(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
           const std::vector<Facet<Dim>>& facets, const Eigen::VectorXd& u, const Eigen::VectorXd& area);
  bool empty() const { return m_vertices.empty(); }
  /// Fitted values at all candidates; `nodal` stays where no facet is in contact.
  /// @param force nodal forces of the candidates [force]; @param nodal values without a fit [stress]
  Eigen::VectorXd fit(const Eigen::VectorXd& force, Eigen::VectorXd nodal) const;

private:
  struct Quadratic {
    std::vector<int> nodes; // candidate numbers, vertices first
    Eigen::MatrixXd mass;
  };
  std::vector<Quadratic> m_facets;      // in contact
  std::vector<int> m_row, m_column;     // per candidate: of the least-squares problem, -1: none
  std::vector<int> m_nodes, m_vertices; // candidates of its rows and columns
  Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> m_solver;
};

} // namespace burnish
