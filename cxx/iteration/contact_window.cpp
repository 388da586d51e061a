#include "iteration/contact_window.hpp"
#include "contact/slip_motion.hpp"
#include "mesh/point_tree.hpp"
#include <cmath>
#include <limits>

namespace burnish {
namespace {

// Margin of the window around a contact, in node spacings: no whole number, at which rounding would choose the nodes.
constexpr double WINDOW_NODES = 4.3;

template <int Dim>
std::vector<Vector<Dim>> contact_places(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                        const ContactState<Dim>& state, const Eigen::VectorXd& u, int tool) {
  std::vector<Vector<Dim>> places;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    if (in_contact(state.nodes[i].state) && state.nodes[i].tool == tool)
      places.push_back(body.position(u, model.candidates[i]));
  return places;
}

double extent(const std::vector<Vector<3>>& places, const Vector<3>& along) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vector<3>& x : places) {
    low = std::min(low, x.dot(along));
    high = std::max(high, x.dot(along));
  }
  return places.empty() ? 0 : high - low;
}

} // namespace

template <> double least_width(const std::vector<Vector<2>>& places) { return diameter(places); }
template <> double least_width(const std::vector<Vector<3>>& places) {
  if (places.size() < 2) return 0;
  Vector<3> mean = Vector<3>::Zero();
  for (const Vector<3>& x : places) mean += x / static_cast<double>(places.size());
  Tensor<3> spread = Tensor<3>::Zero();
  for (const Vector<3>& x : places) spread += (x - mean) * (x - mean).transpose();
  return extent(places, Eigen::SelfAdjointEigenSolver<Tensor<3>>(spread).eigenvectors().col(1));
}

template <int Dim>
double contact_width(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                     const ContactState<Dim>& state, const Eigen::VectorXd& u, int tool,
                     const Eigen::VectorXd& q_old) {
  const std::vector<Vector<Dim>> places = contact_places(model, body, state, u, tool);
  if constexpr (Dim == 3) {
    constexpr double one_way = 0.5; // resultant of the motions over their sum: below, they have no direction
    if (q_old.size() == state.q.size()) {
      const ContactWay way = contact_way(model, state, q_old, tool);
      if (way.sum.norm() > one_way * way.length) return extent(places, way.sum.normalized());
    }
  }
  return least_width(places);
}

template <int Dim>
std::vector<int> near_contact(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                              const ContactState<Dim>& state, const Eigen::VectorXd& u, double part,
                              const IterationOptions& options) {
  std::vector<char> chosen(state.nodes.size(), 0);
  const auto poses = model.poses(state.q);
  for (int t = 0; t < static_cast<int>(model.tools.size()); ++t) {
    auto centers = contact_places(model, body, state, u, t);
    const double reach = part * WINDOW_NODES * body.spacing;
    double best = std::numeric_limits<double>::infinity();
    Vector<Dim> closest = Vector<Dim>::Zero();
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      if (in_contact(state.nodes[i].state) || !model.may_touch(static_cast<int>(i), t)) continue;
      const Vector<Dim> x = body.position(u, model.candidates[i]);
      const double gap = model.tools[t]->foot(poses[t], x, state.nodes[i].place.hint).gap;
      if (gap < best) {
        best = gap;
        closest = x;
      }
      if (gap < options.gap_tolerance * body.spacing) chosen[i] = 1;
    }
    if (centers.empty() && std::isfinite(best)) centers.push_back(closest);
    const PointTree<Dim> tree(std::move(centers));
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
      if (!chosen[i] && tree.nearest(body.position(u, model.candidates[i])).squared_distance <= reach * reach)
        chosen[i] = 1;
  }
  std::vector<int> near;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i]) near.push_back(static_cast<int>(i));
  return near;
}

template <int Dim>
Eigen::VectorXd scatter_window(const ContactModel<Dim>& model, const std::vector<int>& window,
                               const Eigen::VectorXd& part, Eigen::Index size) {
  Eigen::VectorXd full = Eigen::VectorXd::Zero(size);
  for (std::size_t w = 0; w < window.size(); ++w)
    full.template segment<Dim>(Dim * model.candidates[window[w]]) += part.template segment<Dim>(Dim * w);
  return full;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template double contact_width<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,                         \
                                     const ContactState<Dim>&, const Eigen::VectorXd&, int,                  \
                                     const Eigen::VectorXd&);                                                \
  template std::vector<int> near_contact<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,                \
                                              const ContactState<Dim>&, const Eigen::VectorXd&, double,      \
                                              const IterationOptions&);                                      \
  template Eigen::VectorXd scatter_window<Dim>(const ContactModel<Dim>&, const std::vector<int>&,            \
                                               const Eigen::VectorXd&, Eigen::Index);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
