#pragma once
// The condensed sparse system K^ z = r^ in nodes, slips and tool coordinates: K^ = W' K A + Geo
// (METHOD.md 3.3). One matrix for any sparse solver; the pattern is fixed for the run.
#include "contact/body_view.hpp"
#include "contact/driving_force.hpp"
#include "contact/friction_tangent.hpp"
#include "contact/linearization.hpp"
#include "solver/node_block_matrix.hpp"

namespace burnish {

/// Compressed rows, columns ascending; `half`: lower triangle only.
struct CondensedSystem {
  int n = 0;
  bool half = false;
  std::vector<int> row_start, col;
  std::vector<double> value;
  Eigen::VectorXd rhs;
};

/// What the right-hand side consists of.
enum class RightHandSide {
  TOTAL, ///< applied generalized forces minus the total internal forces
  RATES, ///< increments of the applied forces and motions only: the article's pure rates. Neither forces out
         ///< of balance nor nodes off their tool are corrected; what a release left behind is taken off
         ///< (METHOD.md 3.6)
};

/// What is condensed: forces and tangent at the linearization point, and the form of the system.
template <int Dim> struct CondensedProblem {
  const NodeBlockMatrix<Dim>& K; ///< tangent of the body, symmetric
  const ContactState<Dim>& state;
  const PrescribedValues &end, &start; ///< of the step; the start counts for RATES
  const Eigen::VectorXd &u, &R;        ///< displacement; internal minus external nodal force; num_dofs
  GeometricTerms terms = GeometricTerms::COMPLETE;
  RightHandSide right = RightHandSide::TOTAL;
  bool half = false; ///< lower triangle only: no friction or a LAGGED tangent of it, COMPLETE or NONE terms
  FrictionTangent tangent = FrictionTangent::CONSISTENT;
  std::vector<char> by_friction =
      {}; ///< tools that friction alone holds, of held_by_friction; empty: states stay
};

/// Unknowns: dof d of a free node at position d; a sliding node has its Dim-1 slips at its first dofs and zero at
/// the others; a sticking node zeros; coordinates follow after all dofs. Unknowns that are given (fixed dofs,
/// zeros, coordinates under motion, coordinates that follow others) keep a diagonal entry and their value on the right-hand side.
template <int Dim> class Condensation {
public:
  Condensation(const ContactModel<Dim>& model, const BodyView<Dim>& body) : m_model(model), m_body(body) {}
  /// @throws std::invalid_argument if K has another size than the body, half with friction in a CONSISTENT tangent,
  /// another tangent with RATES
  const CondensedSystem& condense(const CondensedProblem<Dim>& problem);
  /// Solution in nodes, slips, coordinates and the contact forces that it predicts.
  struct Expansion {
    Eigen::VectorXd du;   ///< num_dofs [length]
    Eigen::MatrixXd slip; ///< Dim-1 x candidates, in the tangents E, 0 unless sliding [length]
    Eigen::VectorXd dq;   ///< per coordinate
    Eigen::VectorXd
        F; ///< R + K du on the candidates, Dim*candidates: of those in contact their force [force]
  };
  /// @throws std::invalid_argument if z has not the size of the last condensed system or contains NaN
  Expansion expand(const Eigen::VectorXd& z) const;

private:
  struct Part {
    int node;         // whose unknowns it belongs to
    Tensor<Dim> W, A; // local rows and columns
  };
  struct Map {
    const NodeLinearization<Dim>* node; // nullptr for a free node
    std::array<Part, 2> part;           // its own, or of a tied node those of the ends that slide
    int num = 0;
    const Part* begin() const { return part.data(); }
    const Part* end() const { return part.data() + num; }
  };
  void build_pattern(const NodeBlockMatrix<Dim>& K);
  Map map_of(int node) const;
  void linearize(const CondensedProblem<Dim>& problem);
  void require_form(const CondensedProblem<Dim>& problem) const;
  void add_blocks(const NodeBlockMatrix<Dim>& K);
  void add_coordinate_rows(const NodeLinearization<Dim>& node, const Eigen::MatrixXd& qK, const Map& column);
  void add_geometric_terms();
  void add_drive();
  void keep_candidate_rows(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& R);
  void set_right_hand_side(const CondensedProblem<Dim>& problem);
  void move_geometric_columns(const CondensedProblem<Dim>& problem);
  void set_given(const CondensedProblem<Dim>& problem);
  void keep_lower();
  double& at(int row, int column);

  const ContactModel<Dim>& m_model;
  const BodyView<Dim>& m_body;
  std::vector<int> m_pattern_row_start, m_pattern_col; // of the K that the pattern was built for
  CondensedSystem m_full, m_half;
  std::vector<int> m_contact_of; // per node: index into m_nodes or -1
  std::vector<NodeLinearization<Dim>> m_nodes;
  std::vector<char> m_given;            // per unknown
  Eigen::VectorXd m_known_increment;    // displacement increment that is known: offsets and motions
  std::vector<double> m_candidate_rows; // blocks of K in the rows of the candidates, one row after another
  Eigen::VectorXd m_candidate_R;        // Dim*candidates
  Eigen::VectorXd m_q;                  // coordinates at the linearization point
  DrivingForce m_drive;                 // there
};

} // namespace burnish
