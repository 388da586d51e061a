// Tied edges in space: every block of the condensed tangent against finite differences of the shared rows, on a face whose
// three mid nodes are tied to corners that slide or stick.
#include "unit/contact/bound_nodes.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Corners 0 to 2, mid nodes 3 to 5 behind them (01, 12, 20), two free nodes.
struct TiedFace : BoundNodes<8> {
  static constexpr int CORNERS = 3, TOUCHING = 6;
  static constexpr double MU = 0.3;

  /// @param sliding per corner, 's' or 'k'
  TiedFace(std::shared_ptr<const Surface<3>> shape, const std::string& sliding, double mu)
      : BoundNodes(std::move(shape), mu, 11) {
    model.edge_ends.assign(NODES, {-1, -1});
    for (int e = 0; e < 3; ++e) model.edge_ends[3 + e] = {e, (e + 1) % 3};
    state.q << 0.1, 0.05, -0.2, 0.1, 0.3, -0.15;
    const Vector<3> above[] = {{0.1, 0.2, 2}, {0.35, 0.25, 2}, {0.2, 0.45, 2}};
    for (int i = 0; i < CORNERS; ++i) {
      touch(i, above[i]);
      const Param<3> slip(0.05 * any(), 0.05 * any());
      if (sliding[i] == 's') slide(i, tangent_vector(i, slip));
    }
    for (int m = CORNERS; m < TOUCHING; ++m) {
      const auto& [a, b] = model.edge_ends[m];
      touch(m, 0.5 * (above[a] + above[b]));
      state.nodes[m].tied = true;
    }
    follow_ends(model, state);
    settle();
    press(TOUCHING, [](int i) { return Param<3>(0.3 + 0.1 * i, -0.4); });
  }
  bool slides(int corner) const { return state.nodes[corner].state == NodeState::SLIDING; }
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
      const Param<3> T = at.E.transpose() * sum, tau = T - state.slip_stiffness * slip_of(model, nodes[c], 1);
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
  const auto surfaces = four_surfaces();
  return {{"plane", surfaces[0], 1e-7},
          {"cylinder", surfaces[1], 1e-7},
          {"sphere", surfaces[2], 1e-7},
          {"torus", surfaces[3], 1e-3}};
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
