// Ties against nodes on their own on T6, where contact is rolled, dragged and taken off: one line of the table in ALGORITHMS.md 5.3 a run,
// and what both must have in common.
#include "contact/corner_shares.hpp"
#include "contact/surface_report.hpp"
#include "contact/tied_edges.hpp"
#include "support/rolled_tetrahedra.hpp"
#include <cstdio>
#include <ctime>
#include <numeric>

using namespace burnish;
using namespace burnish::test;

namespace {

/// What is read from every step of a part of the program.
struct Zones {
  long steps = 0, one = 0, one_read = 0, changes = 0;
  std::vector<char> before; // per candidate: 1 slides, 2 sticks, 0 does not decide

  /// Number of pieces of the chosen candidates, joined within facets.
  static int pieces(const RolledTetrahedra& scene, const std::vector<char>& chosen) {
    const std::vector<int> candidate = candidate_of_node(scene.setup->candidates(), scene.mesh.num_nodes);
    std::vector<int> parent(chosen.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
      while (parent[i] != i) i = parent[i];
      return i;
    };
    for (const Facet<3>& facet : scene.mesh.facets) {
      int first = -1;
      for (const int node : nodes_of(facet)) {
        const int i = candidate[node];
        if (i < 0 || !chosen[i]) continue;
        if (first >= 0) parent[root(i)] = root(first);
        first = i;
      }
    }
    int number = 0;
    for (int i = 0; i < static_cast<int>(chosen.size()); ++i) number += chosen[i] && parent[i] == i;
    return number;
  }
  /// Corners whose shared forces are well inside the cone.
  static std::vector<char> inside_cone(const RolledTetrahedra& scene) {
    const auto& accepted = scene.contact->accepted();
    const ContactModel<3>& model = scene.setup->model();
    const SurfaceReport<3> report = surface_report(model, scene.setup->body(), accepted.contact,
                                                   scene.setup->surface(), accepted.u, accepted.R);
    const CornerShares<3> shares(model, scene.setup->body(), accepted.contact, scene.setup->surface(),
                                 accepted.u, report.area);
    const Eigen::VectorXd N = shares.shared(report.normal_force);
    Eigen::MatrixXd T(3, N.size());
    for (int a = 0; a < 3; ++a)
      T.row(a) = shares.shared(report.tangential_force.row(a).transpose()).transpose();
    std::vector<char> inside(accepted.contact.nodes.size(), 0);
    for (Eigen::Index c = 0; c < N.size(); ++c)
      inside[shares.corners()[static_cast<std::size_t>(c)]] =
          T.col(c).norm() < 0.97 * model.laws[0].capacity(N[c], 1);
    return inside;
  }
  void look(const RolledTetrahedra& scene) {
    const auto& nodes = scene.contact->accepted().contact.nodes;
    std::vector<char> now(nodes.size(), 0), sticking = now;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      if (!in_contact(nodes[i].state) || nodes[i].tied) continue;
      if (scene.setup->model().law(i, nodes[i]).frictionless()) continue;
      sticking[i] = sticks(nodes[i].state);
      now[i] = sticking[i] ? 2 : 1;
      if (!before.empty() && before[i]) changes += before[i] != now[i];
    }
    before = now;
    ++steps;
    one += pieces(scene, sticking) == 1;
    one_read += pieces(scene, inside_cone(scene)) == 1;
  }
};

struct Measured {
  long steps = 0, rejected = 0;
  double depth = 0, theta = 0, force = 0, strain = 0, one = 0;
};

/// Runs a scene and prints its line: after `press`, what `part` does.
Measured measure(const char* name, RolledTetrahedra& scene, int press,
                 const std::function<Task(RolledTetrahedra&)>& part) {
  const std::clock_t start = std::clock();
  Zones zones;
  EXPECT_EQ(scene.press(press), Task::FINISHED);
  scene.on_step = [&] { zones.look(scene); };
  EXPECT_EQ(part(scene), Task::FINISHED);
  const auto& counts = scene.contact->iteration().counts();
  const double P = scene.load;
  const Measured m{scene.steps,
                   scene.rejected,
                   scene.depth(),
                   scene.theta(),
                   scene.tool->generalized_force()[0] / P,
                   scene.plastic_strain(),
                   static_cast<double>(zones.one) / static_cast<double>(zones.steps)};
  std::printf(
      "| %s | %s | %ld / %ld | %.1f / %.1f | %.5f | %.5f | %.4f | %.4f | %.0f | %.0f | %.1f | %.0f |\n", name,
      scene.contact->iteration().options().tied ? "tied" : "alone", m.steps, m.rejected,
      static_cast<double>(counts.iterations) / static_cast<double>(m.steps),
      static_cast<double>(counts.factorizations) / static_cast<double>(m.steps), m.depth, m.theta, m.force,
      m.strain, 100 * m.one, 100. * static_cast<double>(zones.one_read) / static_cast<double>(zones.steps),
      static_cast<double>(zones.changes) / static_cast<double>(zones.steps),
      static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  if (!scene.reasons().empty()) std::printf("%s\n", scene.reasons().c_str());
  std::fflush(stdout);
  return m;
}

IterationOptions ties(bool tied) {
  IterationOptions options;
  options.tied = tied;
  return options;
}

} // namespace

TEST(TiesOnTetrahedra, SlabRolled) {
  Measured of[2];
  for (const bool tied : {false, true}) {
    const auto scene = slab(0.02, 0.06, 0.3, 0.2, 10, 0.4, ties(tied));
    of[tied] = measure("slab rolled", *scene, 6,
                       [](RolledTetrahedra& s) { return s.roll(32, 0.3, 0.6 * 0.2 * s.load, 0.05); });
  }
  EXPECT_NEAR(of[1].depth, of[0].depth, 1e-2 * of[0].depth); // measured: 0.7 %
  EXPECT_NEAR(of[1].force, of[0].force, 1e-2 * std::abs(of[0].force));
  EXPECT_EQ(of[1].rejected, 0);
  EXPECT_GT(of[1].one, 0.7); // measured: 0.81, the vertices with 8 facets are at the cone
}

// The same where all inner vertices have six facets.
TEST(TiesOnTetrahedra, EvenSlabRolled) {
  Measured of[2];
  for (const bool tied : {false, true}) {
    Slab even{0.02, 0.06, 0.3};
    even.mirrored = false;
    const auto scene = even.scene(ties(tied));
    of[tied] = measure("slab rolled, even", *scene, 6,
                       [](RolledTetrahedra& s) { return s.roll(32, 0.3, 0.6 * 0.2 * s.load, 0.05); });
    EXPECT_EQ(of[tied].rejected, 0);
  }
  EXPECT_NEAR(of[1].depth, of[0].depth, 1e-3 * of[0].depth); // measured: 0.07 %
  EXPECT_NEAR(of[1].theta, of[0].theta, 1e-4 * of[0].theta); // measured: 4e-5
  EXPECT_GE(of[1].one, 0.95);                                // measured: 1
}

TEST(TiesOnTetrahedra, SlabDragged) {
  Measured of[2];
  for (const bool tied : {false, true}) {
    const auto scene = slab(0.02, 0.06, 0.1, 0.2, 10, 0.4, ties(tied));
    of[tied] = measure("slab dragged", *scene, 8, [](RolledTetrahedra& s) { return s.drag(11, 0.1); });
  }
  EXPECT_LE(of[1].steps, 20);
  EXPECT_EQ(of[1].rejected, 0);
}

TEST(TiesOnTetrahedra, BallRolled) {
  Measured of[2];
  for (const bool tied : {false, true}) {
    const auto scene = BallOnBlock{0.0267, 0.24}.scene(ties(tied));
    of[tied] = measure("ball rolled", *scene, 6,
                       [](RolledTetrahedra& s) { return s.roll(15, 0.24, 0.6 * 0.2 * s.load, 0.05); });
  }
  EXPECT_NEAR(of[1].depth, of[0].depth, 2e-3 * of[0].depth);
  EXPECT_NEAR(of[1].strain, of[0].strain, 1e-2 * of[0].strain);
  EXPECT_LE(of[1].rejected, 1); // measured: 1, alone too
}

TEST(TiesOnTetrahedra, BallDragged) {
  for (const bool tied : {false, true}) {
    const auto scene = BallOnBlock{0.0267, 0.08}.scene(ties(tied));
    const Measured m =
        measure("ball dragged", *scene, 6, [](RolledTetrahedra& s) { return s.drag(8, 0.08); });
    EXPECT_LE(m.rejected, tied ? 0 : 1);
  }
}

TEST(TiesOnTetrahedra, BallComesOff) {
  for (const bool tied : {false, true}) {
    const auto scene = BallOnBlock{0.0267, 0.02, 0.05}.scene(ties(tied));
    const Measured m = measure("ball taken off", *scene, 6, [](RolledTetrahedra& s) { return s.unload(8); });
    EXPECT_EQ(m.rejected, 0);
  }
}

TEST(TiesOnTetrahedra, BallWithLittleFriction) {
  for (const bool tied : {false, true}) {
    const auto scene = BallOnBlock{0.0267, 0.17, 0.05}.scene(ties(tied));
    const Measured m = measure("ball rolled, mu = 0.05", *scene, 8, [](RolledTetrahedra& s) {
      return s.roll(14, 0.17, 0.6 * 0.05 * s.load, 0.05);
    });
    EXPECT_LE(m.rejected, tied ? 1 : 2); // asked: none, measured: these
  }
}
