#include "workpiece/point_fields.hpp"

namespace burnish {
namespace {

template <int Dim, class Value> Eigen::VectorXd scalars(const Workpiece<Dim>& body, const Value& value) {
  Eigen::VectorXd field(body.discretization().num_points());
  for (int p = 0; p < field.size(); ++p) field[p] = value(p);
  return field;
}

// value(p) is an Eigen object, stored as it lies in memory.
template <int Dim, class Value> std::vector<double> tensors(const Workpiece<Dim>& body, const Value& value) {
  std::vector<double> field;
  for (int p = 0; p < body.discretization().num_points(); ++p) {
    const auto tensor = value(p);
    field.insert(field.end(), tensor.data(), tensor.data() + tensor.size());
  }
  return field;
}

} // namespace

template <int Dim> Eigen::VectorXd stress_eq_field(const Workpiece<Dim>& body) {
  return scalars(body, [&](int p) { return body.stress_eq(p); });
}
template <int Dim> Eigen::VectorXd yield_distance_field(const Workpiece<Dim>& body) {
  return scalars(body, [&](int p) { return body.yield_distance(p); });
}
template <int Dim> std::vector<double> piola_field(const Workpiece<Dim>& body) {
  return tensors(body, [&](int p) { return body.point_piola(p); });
}
template <int Dim> std::vector<double> moduli_field(const Workpiece<Dim>& body, TangentKind kind) {
  return tensors(body, [&](int p) { return body.point_moduli(p, kind); });
}

template Eigen::VectorXd stress_eq_field<2>(const Workpiece<2>&);
template Eigen::VectorXd stress_eq_field<3>(const Workpiece<3>&);
template Eigen::VectorXd yield_distance_field<2>(const Workpiece<2>&);
template Eigen::VectorXd yield_distance_field<3>(const Workpiece<3>&);
template std::vector<double> piola_field<2>(const Workpiece<2>&);
template std::vector<double> piola_field<3>(const Workpiece<3>&);
template std::vector<double> moduli_field<2>(const Workpiece<2>&, TangentKind);
template std::vector<double> moduli_field<3>(const Workpiece<3>&, TangentKind);

} // namespace burnish
