#include "contact/coupling.hpp"
#include "base/error.hpp"
#include <algorithm>

namespace burnish {

template <int Dim> void follow(const ContactModel<Dim>& model, Eigen::VectorXd& q) {
  for (const Coupling& coupling : model.couplings) q[coupling.dependent] = coupling.formula->value(q.data());
}

Eigen::VectorXd slopes_of(const Coupling& coupling, const Eigen::VectorXd& q) {
  const std::size_t number = coupling.formula->arguments().size();
  Eigen::VectorXd slopes(static_cast<Eigen::Index>(number));
  for (std::size_t i = 0; i < number; ++i)
    slopes[static_cast<Eigen::Index>(i)] =
        coupling.formula->first(i, q.data(), static_cast<std::size_t>(q.size()));
  return slopes;
}

template <int Dim>
void follow_increment(const ContactModel<Dim>& model, const Eigen::VectorXd& q, Eigen::VectorXd& dq) {
  for (const Coupling& coupling : model.couplings) {
    const Eigen::VectorXd slopes = slopes_of(coupling, q);
    dq[coupling.dependent] = 0;
    for (std::size_t i = 0; i < coupling.formula->arguments().size(); ++i)
      dq[coupling.dependent] += slopes[static_cast<Eigen::Index>(i)] * dq[coupling.formula->arguments()[i]];
  }
}

template <int Dim>
void pass_on_forces(const ContactModel<Dim>& model, const Eigen::VectorXd& q, Eigen::VectorXd& force) {
  for (const Coupling& coupling : model.couplings) {
    const Eigen::VectorXd slopes = slopes_of(coupling, q);
    for (std::size_t i = 0; i < coupling.formula->arguments().size(); ++i)
      force[coupling.formula->arguments()[i]] +=
          slopes[static_cast<Eigen::Index>(i)] * force[coupling.dependent];
  }
}

namespace {

// Columns of the node's old coordinates over those of independent ones: dq_tool = B dp.
struct Reduction {
  std::vector<int> at;
  Eigen::MatrixXd B;
};

template <int Dim>
Reduction reduction(const ContactModel<Dim>& model, const Eigen::VectorXd& q, const std::vector<int>& old) {
  Reduction result;
  const auto column = [&](int k) {
    const auto found = std::find(result.at.begin(), result.at.end(), k);
    if (found == result.at.end()) {
      result.at.push_back(k);
      return static_cast<Eigen::Index>(result.at.size()) - 1;
    }
    return static_cast<Eigen::Index>(found - result.at.begin());
  };
  const auto rows = static_cast<Eigen::Index>(old.size());
  result.B = Eigen::MatrixXd::Zero(rows, model.num_coordinates());
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Coupling* coupling = model.coupling_of(old[static_cast<std::size_t>(k)]);
    if (!coupling) {
      result.B(k, column(old[static_cast<std::size_t>(k)])) = 1;
      continue;
    }
    const Eigen::VectorXd slopes = slopes_of(*coupling, q);
    for (std::size_t i = 0; i < coupling->formula->arguments().size(); ++i)
      result.B(k, column(coupling->formula->arguments()[i])) += slopes[static_cast<Eigen::Index>(i)];
  }
  result.B = result.B.leftCols(static_cast<Eigen::Index>(result.at.size())).eval();
  return result;
}

// F.X_,d f_,ij of one relation, added to the coordinates' block.
void add_curvature(const Coupling& coupling, const Eigen::VectorXd& q, double force,
                   const std::vector<int>& at, Eigen::MatrixXd& block) {
  const std::vector<int>& arguments = coupling.formula->arguments();
  const auto place = [&](std::size_t i) {
    return static_cast<Eigen::Index>(std::find(at.begin(), at.end(), arguments[i]) - at.begin());
  };
  for (std::size_t i = 0; i < arguments.size(); ++i)
    for (std::size_t j = 0; j < arguments.size(); ++j)
      block(place(i), place(j)) +=
          force * coupling.formula->second(i, j, q.data(), static_cast<std::size_t>(q.size()));
}

} // namespace

template <int Dim>
void eliminate_followers(const ContactModel<Dim>& model, const Eigen::VectorXd& q, GeometricTerms terms,
                         NodeLinearization<Dim>& node) {
  const std::vector<int> old = node.at;
  if (std::none_of(old.begin(), old.end(), [&](int k) { return model.coupling_of(k) != nullptr; })) return;
  const Reduction to = reduction(model, q, old);
  const Eigen::VectorXd forces = node.point.x_q.transpose() * node.F;
  node.at = to.at;
  node.x_q = (node.x_q * to.B).eval();
  node.geo_sq = (node.geo_sq * to.B).eval();
  node.geo_qs = (node.geo_qs * to.B).eval();
  for (TiedRow<Dim>& tied : node.ties) {
    tied.geo_sq = (tied.geo_sq * to.B).eval();
    tied.geo_qs = (tied.geo_qs * to.B).eval();
  }
  node.geo_qq = (to.B.transpose() * node.geo_qq * to.B).eval();
  for (std::size_t k = 0; terms == GeometricTerms::COMPLETE && k < old.size(); ++k)
    if (const Coupling* coupling = model.coupling_of(old[k]))
      add_curvature(*coupling, q, forces[static_cast<Eigen::Index>(k)], to.at, node.geo_qq);
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template void follow<Dim>(const ContactModel<Dim>&, Eigen::VectorXd&);                                     \
  template void follow_increment<Dim>(const ContactModel<Dim>&, const Eigen::VectorXd&, Eigen::VectorXd&);   \
  template void pass_on_forces<Dim>(const ContactModel<Dim>&, const Eigen::VectorXd&, Eigen::VectorXd&);     \
  template void eliminate_followers<Dim>(const ContactModel<Dim>&, const Eigen::VectorXd&, GeometricTerms,   \
                                         NodeLinearization<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
