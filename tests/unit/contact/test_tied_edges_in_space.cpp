// Tied edges in space: every block of the condensed tangent against finite differences of the shared rows, on a face whose
// three mid nodes are tied to corners that slide or stick.
#include "contact/condensation.hpp"
#include "contact/slip_direction.hpp"
#include "geometry/plane_surface.hpp"
#include "geometry/simple_surfaces.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "unit/contact/spring_body.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Corners 0 to 2, mid nodes 3 to 5 behind them (01, 12, 20), two free nodes; all bound to one another by a potential.
struct TiedFace {
  static constexpr int CORNERS = 3, TOUCHING = 6, NODES = 8, DOFS = 3 * NODES, Q = 6;
  static constexpr double MU = 0.3, C = 0.4;
  ContactModel<3> model;
  BodyView<3> body;
  ContactState<3> state;
  PrescribedValues prescribed;
  NodeBlockMatrix<3> K = pattern_from_elements<3>(NODES, NODES, {0, 1, 2, 3, 4, 5, 6, 7});
  Eigen::MatrixXd stiffness;
  Eigen::VectorXd along, u = Eigen::VectorXd::Zero(DOFS), load = u;

  /// @param sliding per corner, 's' or 'k'
  TiedFace(std::shared_ptr<const Surface<3>> surface, const std::string& sliding, double mu) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto any = [&] { return uniform(random); };
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(DOFS, DOFS, any);
    stiffness = A * A.transpose() / DOFS + 0.5 * Eigen::MatrixXd::Identity(DOFS, DOFS);
    along = Eigen::VectorXd::NullaryExpr(DOFS, any);
    model.tools = {std::make_shared<Tool<3>>("tool", surface, std::make_shared<CartesianInSpace>())};
    model.laws.emplace_back(make_coulomb(mu));
    model.first = {0, Q};
    model.candidates = {0, 1, 2, 3, 4, 5, 6, 7};
    model.edge_ends.assign(NODES, {-1, -1});
    for (int e = 0; e < 3; ++e) model.edge_ends[3 + e] = {e, (e + 1) % 3};
    body.X = Eigen::VectorXd::Zero(DOFS);
    body.fixed.assign(DOFS, 0);
    state.nodes.resize(NODES);
    state.q = Eigen::VectorXd::Zero(Q);
    state.q << 0.1, 0.05, -0.2, 0.1, 0.3, -0.15;
    state.slip_stiffness = C;
    prescribed.is_motion.assign(Q, 0);
    prescribed.value = Eigen::VectorXd::Zero(Q);
    const Vector<3> above[] = {{0.1, 0.2, 2}, {0.35, 0.25, 2}, {0.2, 0.45, 2}};
    for (int i = 0; i < CORNERS; ++i)
      touch(*surface, i, above[i], Param<3>(0.05 * any(), 0.05 * any()), sliding[i] == 's');
    for (int m = CORNERS; m < TOUCHING; ++m) {
      const auto& [a, b] = model.edge_ends[m];
      touch(*surface, m, 0.5 * (above[a] + above[b]), Param<3>::Zero(), false);
      state.nodes[m].tied = true;
    }
    follow_ends(model, state);
    const auto pose = model.poses(state.q)[0];
    for (int i = 0; i < TOUCHING; ++i)
      u.segment<3>(3 * i) = model.tools[0]->position(pose, state.nodes[i].place);
    for (int d = 3 * TOUCHING; d < DOFS; ++d) u[d] = any();
    const Eigen::VectorXd own = force(u);
    for (int i = 0; i < TOUCHING; ++i) { // pressed, and pulled along
      const SurfacePoint<3> p = model.tools[0]->point(pose, state.nodes[i].place);
      load.segment<3>(3 * i) = p.n + p.E * Param<3>(0.3 + 0.1 * i, -0.4) - own.segment<3>(3 * i);
    }
    if (mu > 0) turn_slips(model, force(u), state);
  }
  void touch(const Surface<3>& surface, int i, const Vector<3>& near, const Param<3>& slip, bool slides) {
    ContactNode<3>& node = state.nodes[i];
    node.tool = 0;
    node.state = NodeState::STICKING;
    place_at(node, surface.foot(near, Param<3>::Zero()).place);
    if (!slides) return;
    const Vector<3> way = surface.frame(node.place).E * slip;
    node.slip_origin = surface.foot(node.place.y - way, node.place.hint).place;
    make_slide(node, Vector<3>(model.laws[0].frictionless() ? Vector<3>::Zero() : way.normalized()));
  }
  bool slides(int corner) const { return state.nodes[corner].state == NodeState::SLIDING; }
  Eigen::VectorXd force(const Eigen::VectorXd& x) const {
    return stiffness * x + 0.1 * std::pow(along.dot(x), 2) * along + load;
  }
  Eigen::MatrixXd tangent() {
    const Eigen::MatrixXd k = stiffness + 0.2 * along.dot(u) * along * along.transpose();
    for (int a = 0; a < NODES; ++a)
      for (int b = 0; b < NODES; ++b)
        Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&K.value[9 * K.find(a, b)]) =
            k.block<3, 3>(3 * a, 3 * b);
    Condensation<3> condensation(model, body);
    return dense(
        condensation.condense({K, state, prescribed, prescribed, u, force(u), GeometricTerms::COMPLETE}));
  }
  std::vector<int> slips() const {
    std::vector<int> list;
    for (int i = 0; i < CORNERS; ++i)
      if (slides(i)) list.insert(list.end(), {3 * i, 3 * i + 1});
    return list;
  }
  static std::vector<int> from_to(int first, int last) {
    std::vector<int> list;
    for (int i = first; i < last; ++i) list.push_back(i);
    return list;
  }
  /// Residual after a change z of slips, free nodes and coordinates, from METHOD.md (3.21a), (3.22a); rows of slips in the tool's
  /// frame, seen in the tangents before the change.
  Eigen::VectorXd residual(const Eigen::VectorXd& z) const {
    const Tool<3>& tool = *model.tools[0];
    const Surface<3>& surface = tool.surface();
    const auto pose = model.poses(state.q + z.tail(Q))[0];
    Eigen::VectorXd x = u, r = Eigen::VectorXd::Zero(z.size());
    std::vector<ContactNode<3>> nodes = state.nodes;
    std::vector<Tensor<3>> G(NODES, Tensor<3>::Identity());
    x.tail(DOFS - 3 * TOUCHING) += z.segment(3 * TOUCHING, DOFS - 3 * TOUCHING);
    for (int i = 0; i < CORNERS; ++i)
      if (slides(i)) nodes[i].place = surface.moved(nodes[i].place, Param<3>(z.segment<2>(3 * i)));
    for (int m = CORNERS; m < TOUCHING; ++m) {
      Vector<3> p = nodes[m].slip_origin.y;
      for (const int e : model.edge_ends[m]) p += 0.5 * (nodes[e].place.y - nodes[e].slip_origin.y);
      nodes[m].place = surface.foot(p, nodes[m].place.hint).place;
      const SurfaceFrame<3> f = surface.frame(nodes[m].place);
      const Tensor<3> I = Tensor<3>::Identity(), W = f.E * f.B * f.E.transpose();
      G[m] = (I + f.n.dot(p - nodes[m].place.y) * W).inverse() * (I - f.n * f.n.transpose());
    }
    for (int i = 0; i < TOUCHING; ++i) x.segment<3>(3 * i) = tool.position(pose, nodes[i].place);
    const Eigen::VectorXd R = force(x);
    r.segment(3 * TOUCHING, DOFS - 3 * TOUCHING) = R.tail(DOFS - 3 * TOUCHING);
    std::vector<Vector<3>> f;
    for (int i = 0; i < TOUCHING; ++i) {
      f.push_back(pose.R.transpose() * R.segment<3>(3 * i));
      r.tail(Q) += tool.point(pose, nodes[i].place).x_q.transpose() * R.segment<3>(3 * i);
    }
    for (int c = 0; c < CORNERS; ++c) {
      const SurfaceFrame<3> at = surface.frame(nodes[c].place);
      Vector<3> sum = f[c];
      double N = f[c].dot(at.n);
      for (int m = CORNERS; m < TOUCHING; ++m)
        if (model.edge_ends[m][0] == c || model.edge_ends[m][1] == c) {
          sum += 0.5 * G[m].transpose() * f[m];
          N += 0.5 * f[m].dot(surface.frame(nodes[m].place).n);
        }
      if (!slides(c)) continue;
      const Param<3> T = at.E.transpose() * sum, tau = T - C * slip_of(model, nodes[c]);
      const Param<3> row = T - MU * N * tau.normalized();
      r.segment<2>(3 * c) = surface.frame(state.nodes[c].place).E.transpose() * (at.E * row);
    }
    return r;
  }
};

struct Part {
  const char* name;
  std::shared_ptr<const Surface<3>> surface;
  double tolerance; // of the block of slips: the torus lacks the gradient of the curvature
};
std::vector<Part> parts() {
  AxisFrame axis;
  axis.base << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  axis.point = Vector<3>(0, -4, 0);
  AxisFrame ring = axis;
  ring.point.setZero();
  return {{"plane", std::make_shared<PlaneSurface>(Vector<3>(0, 0, 1), Vector<3>(0, 0, 1), 1), 1e-7},
          {"cylinder", cylinder(1.5, 8, axis), 1e-7},
          {"sphere", sphere(1.3), 1e-7},
          {"torus", torus(1.2, 0.4, ring), 1e-3}};
}

} // namespace

TEST(TiedEdgesInSpace, TangentAgainstFiniteDifferences) {
  for (const Part& part : parts())
    for (const char* sliding : {"sss", "kss", "skk"}) {
      SCOPED_TRACE(std::string(part.name) + " " + sliding);
      TiedFace s(part.surface, sliding, TiedFace::MU);
      const Eigen::MatrixXd K = s.tangent();
      const std::vector<int> slips = s.slips(), nodes = TiedFace::from_to(18, 24),
                             q = TiedFace::from_to(24, 30);
      Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(30, 30);
      for (const auto& columns : {slips, nodes, q})
        for (const int j : columns)
          expected.col(j) = finite_difference(
              [&](double t) { return s.residual(t * Eigen::VectorXd::Unit(30, j)); }, 0, 1e-3);
      for (const auto& rows : {slips, nodes, q})
        for (const auto& columns : {slips, nodes, q}) {
          const bool ss = rows[0] == slips[0] && columns[0] == slips[0];
          const double size = expected(rows, columns).norm(),
                       error = (K(rows, columns) - expected(rows, columns)).norm() / size;
          EXPECT_LE(error, ss ? part.tolerance : 1e-7) << "rows " << rows[0] << ", columns " << columns[0];
        }
    }
}

TEST(TiedEdgesInSpace, SymmetricWithoutFriction) {
  for (const Part& part : parts()) {
    TiedFace s(part.surface, "sss", 0);
    const Eigen::MatrixXd K = s.tangent();
    EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm()) << part.name;
  }
}

// The forces that decide at a corner are those of its row; ends that stick get their part too.
TEST(TiedEdgesInSpace, ForcesGoToTheEnds) {
  TiedFace s(parts()[2].surface, "skk", TiedFace::MU);
  const auto poses = s.model.poses(s.state.q);
  const auto deciding = deciding_forces(s.model, s.state, poses, s.force(s.u));
  const Surface<3>& surface = s.model.tools[0]->surface();
  const Eigen::VectorXd R = s.force(s.u);
  for (int c = 0; c < 3; ++c) {
    Vector<3> sum = poses[0].R.transpose() * R.segment<3>(3 * c);
    double N = sum.dot(surface.frame(s.state.nodes[c].place).n);
    for (int m = 3; m < 6; ++m) {
      if (s.model.edge_ends[m][0] != c && s.model.edge_ends[m][1] != c) continue;
      const SurfaceFrame<3> frame = surface.frame(s.state.nodes[m].place);
      Vector<3> p = s.state.nodes[m].slip_origin.y;
      for (const int e : s.model.edge_ends[m])
        p += 0.5 * (s.state.nodes[e].place.y - s.state.nodes[e].slip_origin.y);
      const double lift = (p - s.state.nodes[m].place.y).dot(frame.n);
      const Vector<3> f = poses[0].R.transpose() * R.segment<3>(3 * m);
      sum += 0.5 / (1 + lift / 1.3) * (f - frame.n * frame.n.dot(f)); // of a sphere
      N += 0.5 * f.dot(frame.n);
    }
    const Param<3> T = surface.frame(s.state.nodes[c].place).E.transpose() * sum;
    EXPECT_NEAR(deciding[c].force.N, N, 1e-13);
    EXPECT_LE((deciding[c].force.T - T).norm(), 1e-13);
  }
  EXPECT_NEAR(deciding[3].force.N, 1, 1e-13) << "a tied node keeps its own";
}

// Half of the chords of both ends, on the surface; where both stick, at its own place.
TEST(TiedEdgesInSpace, MidNodeFollowsItsEnds) {
  TiedFace s(parts()[2].surface, "ssk", TiedFace::MU);
  const Surface<3>& surface = s.model.tools[0]->surface();
  const auto& nodes = s.state.nodes;
  const Vector<3> expected = nodes[3].slip_origin.y + 0.5 * (nodes[0].place.y - nodes[0].slip_origin.y) +
                             0.5 * (nodes[1].place.y - nodes[1].slip_origin.y);
  EXPECT_LE((nodes[3].place.y - 1.3 * expected.normalized()).norm(), 1e-14) << surface.length_scale();
  EXPECT_EQ(nodes[3].state, NodeState::SLIDING);
  make_stick(s.state.nodes[0]);
  follow_ends(s.model, s.state);
  EXPECT_EQ(nodes[5].state, NodeState::STICKING);
  EXPECT_EQ((nodes[5].place.y - nodes[5].slip_origin.y).norm(), 0);
}
