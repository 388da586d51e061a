#include "iteration/contact_window.hpp"
#include "mesh/point_tree.hpp"
#include <cmath>
#include <limits>

namespace burnish {
namespace {

// Margin of the window beyond both ends of a contact: its width times the one plus so many node spacings.
constexpr double WINDOW_WIDTH = 0.75, WINDOW_NODES = 6;

template <int Dim>
std::vector<Vector<Dim>> contact_places(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                        const ContactState<Dim>& state, const Eigen::VectorXd& u, int tool) {
  std::vector<Vector<Dim>> places;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    if (in_contact(state.nodes[i].state) && state.nodes[i].tool == tool)
      places.push_back(body.position(u, model.candidates[i]));
  return places;
}

} // namespace

template <int Dim>
double contact_width(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                     const ContactState<Dim>& state, const Eigen::VectorXd& u, int tool) {
  return diameter(contact_places(model, body, state, u, tool));
}

template <int Dim>
std::vector<int> near_contact(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                              const ContactState<Dim>& state, const Eigen::VectorXd& u, double part,
                              const IterationOptions& options) {
  std::vector<char> chosen(state.nodes.size(), 0);
  const auto poses = model.poses(state.q);
  for (int t = 0; t < static_cast<int>(model.tools.size()); ++t) {
    auto centers = contact_places(model, body, state, u, t);
    const double reach = part * WINDOW_WIDTH * diameter(centers) + part * WINDOW_NODES * body.spacing;
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
                                     const ContactState<Dim>&, const Eigen::VectorXd&, int);                 \
  template std::vector<int> near_contact<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,                \
                                              const ContactState<Dim>&, const Eigen::VectorXd&, double,      \
                                              const IterationOptions&);                                      \
  template Eigen::VectorXd scatter_window<Dim>(const ContactModel<Dim>&, const std::vector<int>&,            \
                                               const Eigen::VectorXd&, Eigen::Index);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
