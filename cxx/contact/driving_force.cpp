#include "contact/driving_force.hpp"
#include "base/error.hpp"
#include "contact/coupling.hpp"
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr double ROUNDINGS = 16;    // of the terms of a force by formula
constexpr double ASYMMETRY = 1e-12; // relative difference of cross derivatives that is rounding

// Force k with its derivatives by the coordinates of its tool, which begin at `first` in q.
void add_formula(const CoordinateFormula& formula, const PrescribedValues& prescribed,
                 const Eigen::VectorXd& q_tool, int first, int k, DrivingForce& drive) {
  std::vector<double> values(q_tool.data(), q_tool.data() + q_tool.size());
  values.push_back(prescribed.t);
  drive.value[k] = formula.value(values.data());
  double terms = std::abs(drive.value[k]);
  for (std::size_t i = 0; i < formula.arguments().size(); ++i) {
    const int argument = formula.arguments()[i];
    if (argument >= q_tool.size()) continue; // the time
    const double slope = formula.first(i, values.data(), values.size());
    drive.slope(k, first + argument) = slope;
    terms += std::abs(slope * q_tool[argument]);
  }
  drive.rounding[k] = ROUNDINGS * std::numeric_limits<double>::epsilon() * terms;
}

} // namespace

template <int Dim>
DrivingForce driving_force(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                           const Eigen::VectorXd& q) {
  DrivingForce drive;
  drive.value = prescribed.value;
  if (prescribed.formula.empty()) return drive;
  const int nq = model.num_coordinates();
  drive.slope = Eigen::MatrixXd::Zero(nq, nq);
  drive.rounding = Eigen::VectorXd::Zero(nq);
  for (int t = 0; t < static_cast<int>(model.tools.size()); ++t)
    for (int k = model.first[t]; k < model.first[t + 1]; ++k)
      if (prescribed.formula[k] && !prescribed.is_motion[k])
        add_formula(*prescribed.formula[k], prescribed, model.tool_q(q, t), model.first[t], k, drive);
  for (const Coupling& coupling : model.couplings) {
    const Eigen::VectorXd slopes = slopes_of(coupling, q);
    const Eigen::VectorXd column = drive.slope.col(coupling.dependent);
    for (std::size_t i = 0; i < coupling.formula->arguments().size(); ++i)
      drive.slope.col(coupling.formula->arguments()[i]) += slopes[static_cast<Eigen::Index>(i)] * column;
    drive.slope.col(coupling.dependent).setZero();
  }
  return drive;
}

std::vector<char> held_by_drive(const DrivingForce& drive, const PrescribedValues& prescribed) {
  std::vector<char> held;
  for (Eigen::Index k = 0; k < drive.slope.rows(); ++k)
    held.push_back(!prescribed.is_motion[k] && drive.slope(k, k) < 0);
  return held;
}

template <int Dim>
void require_symmetric_drive(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                             const DrivingForce& drive) {
  const Eigen::MatrixXd& slope = drive.slope;
  for (Eigen::Index k = 0; k < slope.rows(); ++k)
    for (Eigen::Index l = 0; l < k; ++l) {
      if (prescribed.is_motion[k] || prescribed.is_motion[l]) continue;
      const double a = slope(k, l), b = slope(l, k);
      if (std::abs(a - b) <= ASYMMETRY * std::max(std::abs(a), std::abs(b))) continue;
      std::ostringstream text;
      text << "symmetric storage needs symmetric forces, but that of "
           << model.coordinate(static_cast<int>(k)) << " changes by " << a << " with "
           << model.coordinate(static_cast<int>(l)) << ", the other way round by " << b
           << "; use an unsymmetric solver";
      fail("condense", text.str());
    }
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template DrivingForce driving_force<Dim>(const ContactModel<Dim>&, const PrescribedValues&,                \
                                           const Eigen::VectorXd&);                                          \
  template void require_symmetric_drive<Dim>(const ContactModel<Dim>&, const PrescribedValues&,              \
                                             const DrivingForce&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
