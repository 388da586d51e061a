#include "remesh/support_transfer.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "mesh/point_tree.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr double SAME = 1e-9; // difference of two values over the largest: rounding

template <int Dim> double longest_edge(const ContactRun<Dim>& run) {
  double longest = 0;
  for (const Facet<Dim>& facet : run.setup().mesh().facets)
    for (const int a : facet.vertex)
      for (const int b : facet.vertex)
        longest = std::max(longest, (run.setup().body().position(run.accepted().u, a) -
                                     run.setup().body().position(run.accepted().u, b))
                                        .norm());
  return longest;
}

// Along every facet that a component is given on.
template <int Dim> void require_moved_as_a_whole(const ContactRun<Dim>& run, const Eigen::VectorXd& values) {
  const BodyView<Dim>& body = run.setup().body();
  const double allowed = SAME * values.cwiseAbs().maxCoeff();
  for (const Facet<Dim>& facet : run.setup().mesh().facets)
    for (int c = 0; c < Dim; ++c)
      for (const int node : nodes_of(facet)) {
        const int a = Dim * facet.vertex[0] + c, b = Dim * node + c;
        if (!body.fixed[a] || !body.fixed[b] || std::abs(values[a] - values[b]) <= allowed) continue;
        fail("remesh", sentence("the support of label ", facet.label,
                                " turns or is stretched: its nodes have moved by ", values[a], " and ",
                                values[b], ", expected supports that move as a whole"));
      }
}

} // namespace

template <int Dim> Eigen::VectorXd supports_on(const ContactRun<Dim>& old, const ContactSetup<Dim>& fresh) {
  const Eigen::VectorXd& values = old.accepted().support_displacement;
  if (values.size() == 0 || values.isZero(0)) return {};
  require_moved_as_a_whole(old, values);
  const BodyView<Dim>&body = old.setup().body(), &now = fresh.body();
  const double reach = longest_edge(old);
  Eigen::VectorXd carried = Eigen::VectorXd::Zero(fresh.mesh().num_dofs());
  for (int c = 0; c < Dim; ++c) {
    std::vector<Vector<Dim>> places;
    std::vector<double> value;
    for (int a = 0; a < old.setup().mesh().num_nodes; ++a) {
      if (!body.fixed[Dim * a + c]) continue;
      places.push_back(body.position(old.accepted().u, a));
      value.push_back(values[Dim * a + c]);
    }
    const PointTree<Dim> tree(std::move(places));
    for (int a = 0; a < fresh.mesh().num_nodes; ++a) {
      if (!now.fixed[Dim * a + c]) continue;
      const auto nearest = tree.nearest(fresh.mesh().node(a));
      if (nearest.index < 0 || nearest.squared_distance > reach * reach)
        fail("remesh", sentence("component ", c, " of node ", a,
                                " is given on the new mesh and was not there on the old one, ",
                                "expected the same supports while they move"));
      carried[Dim * a + c] = value[static_cast<std::size_t>(nearest.index)];
    }
  }
  return carried;
}

template Eigen::VectorXd supports_on<2>(const ContactRun<2>&, const ContactSetup<2>&);
template Eigen::VectorXd supports_on<3>(const ContactRun<3>&, const ContactSetup<3>&);

} // namespace burnish
