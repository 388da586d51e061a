#pragma once
// An artificial body with an exactly known symmetric tangent, touched by tools: what the condensation sees.
#include "cad/occ/cad_curve.hpp"
#include "contact/condensation.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "kinematics/polar.hpp"
#include "kinematics/sized_coordinates.hpp"
#include "solver/sparse_view.hpp"
#include "support/profile_tool.hpp"
#include <random>

namespace burnish::test {

/// Internal force of the potential sum over elements of |B u_e|^2/2 + (v.u_e)^3/3 + (w.u_e)^4/4, random B, v,
/// w. Twelve nodes in a chain of three-node elements; lengths about 1, forces about 1.
class SpringBody {
public:
  static constexpr int NODES = 12;
  /// @param nonlinear size of the cubic and quartic parts; 0: linear, positive definite
  explicit SpringBody(double nonlinear) : m_nonlinear(nonlinear) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto any = [&] { return uniform(random); };
    for (int a = 0; a + 2 < NODES; ++a) {
      m_connectivity.insert(m_connectivity.end(), {a, a + 1, a + 2});
      m_B.push_back(Matrix::NullaryExpr(any));
      m_v.push_back(Local::NullaryExpr(any));
      m_w.push_back(Local::NullaryExpr(any));
    }
    m_matrix = pattern_from_elements<2>(NODES, 3, m_connectivity);
    body.X = Eigen::VectorXd::NullaryExpr(2 * NODES, any);
    body.fixed.assign(2 * NODES, 0);
    body.spacing = 0.5;
  }

  Eigen::VectorXd force(const Eigen::VectorXd& u) const {
    Eigen::VectorXd R = 0.5 * u;
    for (std::size_t e = 0; e < m_B.size(); ++e) {
      const Local x = local(e, u);
      const double v = m_v[e].dot(x), w = m_w[e].dot(x);
      const Local f =
          m_B[e].transpose() * (m_B[e] * x) + m_nonlinear * (v * v * m_v[e] + std::pow(w, 3) * m_w[e]);
      R.segment<6>(2 * static_cast<Eigen::Index>(e)) += f;
    }
    return R;
  }

  const NodeBlockMatrix<2>& tangent(const Eigen::VectorXd& u) {
    std::fill(m_matrix.value.begin(), m_matrix.value.end(), 0.);
    for (int d = 0; d < 2 * NODES; ++d) add(d, d, 0.5);
    for (std::size_t e = 0; e < m_B.size(); ++e) {
      const Local x = local(e, u);
      const double v = m_v[e].dot(x), w = m_w[e].dot(x);
      const Matrix k = m_B[e].transpose() * m_B[e] + m_nonlinear * (2 * v * m_v[e] * m_v[e].transpose() +
                                                                    3 * w * w * m_w[e] * m_w[e].transpose());
      const int first = 2 * static_cast<int>(e);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) add(first + i, first + j, k(i, j));
    }
    return m_matrix;
  }

  BodyView<2> body;

private:
  using Local = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  static Local local(std::size_t e, const Eigen::VectorXd& u) {
    return u.segment<6>(2 * static_cast<Eigen::Index>(e));
  }
  void add(int i, int j, double value) {
    m_matrix.block(m_matrix.find(i / 2, j / 2))[2 * (i % 2) + j % 2] += value;
  }

  double m_nonlinear;
  std::vector<int> m_connectivity;
  std::vector<Matrix> m_B;
  std::vector<Local> m_v, m_w;
  NodeBlockMatrix<2> m_matrix;
};

enum class Shape { CIRCLE, INSIDE, SEGMENT, ARC_CHAIN, SPLINE };
enum class Frame { CARTESIAN, POLAR, CRANK, POLAR_BY_FORMULA, GROWING };

inline std::shared_ptr<const Coordinates<2>> make_coordinates(const std::string& tool, Frame frame) {
  if (frame == Frame::POLAR) return std::make_shared<Polar>(Vector<2>(0.4, -0.3));
  if (frame == Frame::CRANK) // one coordinate: crank and connecting rod, turning the tool a little
    return std::make_shared<FormulaCoordinates<2>>(
        tool, std::vector<std::string>{"beta"},
        PlaneFormulas{"e*cos(beta)+sqrt(l^2-e^2*sin(beta)^2)-1", "h", "beta/2"},
        std::map<std::string, double>{{"e", 0.6}, {"l", 1.5}, {"h", -0.3}});
  if (frame == Frame::GROWING)
    return std::make_shared<SizedCoordinates<2>>(tool, std::make_shared<Polar>(Vector<2>(0.4, -0.3)),
                                                 std::vector<std::string>{"r", "phi", "theta", "R"},
                                                 "R*(1+phi/9)", std::map<std::string, double>{});
  if (frame == Frame::POLAR_BY_FORMULA)
    return std::make_shared<FormulaCoordinates<2>>(
        tool, std::vector<std::string>{"r", "phi", "theta"},
        PlaneFormulas{"0.4+r*cos(phi)", "r*sin(phi)-0.3", "theta"});
  return std::make_shared<Cartesian>();
}

inline std::shared_ptr<const Tool<2>> make_tool(const std::string& name, Shape shape, Frame frame) {
  std::shared_ptr<const Profile<2>> profile;
  if (shape == Shape::SEGMENT)
    profile = std::make_shared<Segment>(Vector<2>(-1, 0.2), Vector<2>(1.5, 0.4));
  else if (shape == Shape::ARC_CHAIN) // joints at s = 0.424, 1.388, 1.877, 2.402
    profile =
        std::make_shared<ArcChain>(std::vector<Vector<2>>{{-1, 0.2}, {-0.2, -0.4}, {0.8, 0.5}, {1.5, 0.4}},
                                   std::vector<double>{0, 0.7, 0.6, 0});
  else if (shape == Shape::SPLINE) { // 6.9 round, knots at multiples of 0.87
    CadSelection lobe;
    lobe.file = "tests/support/cad/lobe.step";
    lobe.scale = 0.118;
    profile = std::make_shared<CadCurve>(lobe);
  } else
    profile = std::make_shared<Circle>(1.3, shape == Shape::INSIDE);
  return profile_tool(name, profile, make_coordinates(name, frame));
}

/// Contact of nodes 3..8 of the body with tools; nothing in contact yet.
struct SpringContact {
  ContactModel<2> model;
  ContactState<2> state;
  PrescribedValues prescribed; ///< zero forces

  SpringContact() { model.first = {0}; }
  void add(std::shared_ptr<const Tool<2>> tool, double mu) {
    model.candidates = {3, 4, 5, 6, 7, 8};
    state.nodes.resize(6);
    model.tools.push_back(std::move(tool));
    model.laws.emplace_back(make_coulomb(mu));
    const int nq = model.tools.back()->coordinates().size();
    model.first.push_back(model.first.back() + nq);
    const int total = model.first.back();
    state.q.conservativeResize(total);
    const double places[] = {0.7, -0.4, 0.3};
    for (int k = 0; k < nq; ++k) state.q[total - nq + k] = places[k % 3] + 0.1 * total;
    prescribed.is_motion.resize(total, 0);
    prescribed.value = Eigen::VectorXd::Zero(total);
  }
  /// @param along 1, -1: slides against friction along the tangent or against it
  void touch(int candidate, int tool, double s, double along, bool slides) {
    ContactNode<2>& node = state.nodes[candidate];
    node.tool = tool;
    place_at(node, place_of(*model.tools[tool], s));
    node.state = slides ? NodeState::SLIDING : NodeState::STICKING;
    node.slip_direction = along * model.tools[tool]->surface().frame(node.place).E;
  }
  /// u with every contact node on its tool.
  void place(const BodyView<2>& body, Eigen::VectorXd& u) const {
    const auto poses = model.poses(state.q);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      const ContactNode<2>& node = state.nodes[i];
      if (!in_contact(node.state)) continue;
      const int a = model.candidates[i];
      u.segment<2>(2 * a) =
          model.tools[node.tool]->position(poses[node.tool], node.place) - body.X.segment<2>(2 * a);
    }
  }
  /// The other way round: moves the body's nodes, so that u brings them onto their tools.
  void settle(BodyView<2>& body, const Eigen::VectorXd& u) const {
    Eigen::VectorXd placed = u;
    place(body, placed);
    body.X += placed - u;
  }
};

/// Dense copy of a condensed system, both triangles.
inline Eigen::MatrixXd dense(const CondensedSystem& system) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(system.n, system.n);
  for (int row = 0; row < system.n; ++row)
    for (int k = system.row_start[row]; k < system.row_start[row + 1]; ++k) {
      matrix(row, system.col[k]) = system.value[k];
      if (system.half) matrix(system.col[k], row) = system.value[k];
    }
  return matrix;
}

inline SparseView view(const CondensedSystem& system) {
  return {system.n, system.row_start.data(), system.col.data(), system.value.data(), system.half};
}

} // namespace burnish::test
