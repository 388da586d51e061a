#include "contact/tributary_area.hpp"

namespace burnish {

template <int Dim>
std::vector<Vector<Dim>> places_of(const BodyView<Dim>& body, const Facet<Dim>& facet,
                                   const Eigen::VectorXd& u) {
  std::vector<Vector<Dim>> places;
  for (const int node : nodes_of(facet)) places.push_back(body.position(u, node));
  return places;
}

template <int Dim>
Eigen::VectorXd tributary_areas(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                const std::vector<Facet<Dim>>& facets, const Eigen::VectorXd& u) {
  const std::vector<int> candidate =
      candidate_of_node(model.candidates, static_cast<int>(body.X.size()) / Dim);
  Eigen::VectorXd area = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.candidates.size()));
  for (const Facet<Dim>& facet : facets) {
    const std::vector<int> nodes = nodes_of(facet);
    const Eigen::VectorXd part = body.measure->masses(places_of(body, facet, u)).rowwise().sum();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (candidate[nodes[i]] >= 0) area[candidate[nodes[i]]] += part[static_cast<Eigen::Index>(i)];
  }
  return area;
}

template std::vector<Vector<2>> places_of<2>(const BodyView<2>&, const Facet<2>&, const Eigen::VectorXd&);
template std::vector<Vector<3>> places_of<3>(const BodyView<3>&, const Facet<3>&, const Eigen::VectorXd&);
template Eigen::VectorXd tributary_areas<2>(const ContactModel<2>&, const BodyView<2>&,
                                            const std::vector<Facet<2>>&, const Eigen::VectorXd&);
template Eigen::VectorXd tributary_areas<3>(const ContactModel<3>&, const BodyView<3>&,
                                            const std::vector<Facet<3>>&, const Eigen::VectorXd&);

} // namespace burnish
