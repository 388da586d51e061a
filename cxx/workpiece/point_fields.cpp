#include "workpiece/point_fields.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

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

template <int Dim>
Eigen::VectorXd hardening_field(const Workpiece<Dim>& body, const Eigen::VectorXd& ep,
                                double YieldStress::*member) {
  const char* where = "material.yieldstress";
  require(ep.size() == body.discretization().num_points(), where, "size of the plastic strains", ep.size(),
          "number of points");
  if (std::isnan(body.law().yield_stress(0).value))
    fail(where, "law \"" + body.law().name() + "\" has no yield stress");
  return scalars(body, [&](int p) { return body.law().yield_stress(ep[p]).*member; });
}

} // namespace

template <int Dim>
Eigen::VectorXd yield_stress_field(const Workpiece<Dim>& body, const Eigen::VectorXd& plastic_strain_eq) {
  return hardening_field(body, plastic_strain_eq, &YieldStress::value);
}
template <int Dim>
Eigen::VectorXd hardening_slope_field(const Workpiece<Dim>& body, const Eigen::VectorXd& plastic_strain_eq) {
  return hardening_field(body, plastic_strain_eq, &YieldStress::slope);
}
template <int Dim>
Eigen::VectorXd internal_field(const Workpiece<Dim>& body, const std::string& name, int component) {
  const int place = body.law().internal_place(name, component, "internal_field");
  return scalars(body, [&](int p) { return point_state(body.state(), p).internal[place]; });
}
template <int Dim> Eigen::VectorXd stress_eq_field(const Workpiece<Dim>& body) {
  return scalars(body,
                 [&](int p) { return equivalent<Dim>(deviator<Dim>(carried_stress(body.state(), p))); });
}
template <int Dim> double yield_distance(const Workpiece<Dim>& body, int point) {
  const PointState<Dim> now = point_state(body.state(), point);
  return body.law().yield_distance(now.stress, now.internal);
}
template <int Dim> double largest_yield_distance(const Workpiece<Dim>& body) {
  double largest = -1;
  for (int p = 0; p < body.discretization().num_points(); ++p)
    largest = std::max(largest, yield_distance(body, p));
  return largest;
}
template <int Dim> Eigen::VectorXd yield_distance_field(const Workpiece<Dim>& body) {
  return scalars(body, [&](int p) { return yield_distance(body, p); });
}
template <int Dim> Eigen::VectorXd integrity_field(const Workpiece<Dim>& body) {
  return scalars(body, [&](int p) { return integrity_of(body.state(), p); });
}
template <int Dim> std::vector<double> stress_field(const Workpiece<Dim>& body) {
  return tensors(body, [&](int p) { return carried_stress(body.state(), p); });
}
template <int Dim> std::vector<double> script_stress_field(const Workpiece<Dim>& body) {
  return body.user_defined() ? body.state().stress : stress_field(body);
}
template <int Dim> std::vector<double> cauchy_field(const Workpiece<Dim>& body) {
  const bool small = body.law().small_strain();
  return tensors(body, [&](int p) -> Stress<Dim> {
    const Gradient<Dim> F = point_state(body.state(), p).F;
    return carried_stress(body.state(), p) / (small ? 1 : determinant(F));
  });
}
template <int Dim> std::vector<double> piola_field(const Workpiece<Dim>& body) {
  return tensors(body, [&](int p) { return carried_piola(body.state(), p, body.law().small_strain()); });
}
template <int Dim>
std::vector<double> moduli_field(const Workpiece<Dim>& body, TangentKind kind, double elastic_blend) {
  return tensors(body, [&](int p) { return body.point_moduli(p, kind, elastic_blend); });
}
template <int Dim> std::vector<double> increments_field(const Workpiece<Dim>& body) {
  return tensors(body, [&](int p) { return body.law().increments(body.point_step(p)).y; });
}

template Eigen::VectorXd internal_field<2>(const Workpiece<2>&, const std::string&, int);
template Eigen::VectorXd internal_field<3>(const Workpiece<3>&, const std::string&, int);
template double yield_distance<2>(const Workpiece<2>&, int);
template double yield_distance<3>(const Workpiece<3>&, int);
template double largest_yield_distance<2>(const Workpiece<2>&);
template double largest_yield_distance<3>(const Workpiece<3>&);
template Eigen::VectorXd integrity_field<2>(const Workpiece<2>&);
template Eigen::VectorXd integrity_field<3>(const Workpiece<3>&);
template std::vector<double> stress_field<2>(const Workpiece<2>&);
template std::vector<double> stress_field<3>(const Workpiece<3>&);
template std::vector<double> script_stress_field<2>(const Workpiece<2>&);
template std::vector<double> script_stress_field<3>(const Workpiece<3>&);
template std::vector<double> cauchy_field<2>(const Workpiece<2>&);
template std::vector<double> cauchy_field<3>(const Workpiece<3>&);
template Eigen::VectorXd stress_eq_field<2>(const Workpiece<2>&);
template Eigen::VectorXd stress_eq_field<3>(const Workpiece<3>&);
template Eigen::VectorXd yield_distance_field<2>(const Workpiece<2>&);
template Eigen::VectorXd yield_distance_field<3>(const Workpiece<3>&);
template Eigen::VectorXd yield_stress_field<2>(const Workpiece<2>&, const Eigen::VectorXd&);
template Eigen::VectorXd hardening_slope_field<2>(const Workpiece<2>&, const Eigen::VectorXd&);
template std::vector<double> piola_field<2>(const Workpiece<2>&);
template Eigen::VectorXd yield_stress_field<3>(const Workpiece<3>&, const Eigen::VectorXd&);
template Eigen::VectorXd hardening_slope_field<3>(const Workpiece<3>&, const Eigen::VectorXd&);
template std::vector<double> piola_field<3>(const Workpiece<3>&);
template std::vector<double> moduli_field<2>(const Workpiece<2>&, TangentKind, double);
template std::vector<double> moduli_field<3>(const Workpiece<3>&, TangentKind, double);
template std::vector<double> increments_field<2>(const Workpiece<2>&);
template std::vector<double> increments_field<3>(const Workpiece<3>&);

} // namespace burnish
