// What a script reads of a material, as arrays over the quadrature points: element by element; P1 its centroid (P0), P2
// the middles of the edges opposite vertex 0, 1, 2 (FEQF2) or, axisymmetric, the inner points nearest to vertex 0, 1, 2,
// with barycentric coordinate 2/3 there and 1/6 at the others. zz is the hoop direction when axisymmetric.
//   M.stress(i)         Kirchhoff stress xx, yy, zz, xy for i = 0..3 [stress]
//   M.F(i), M.piola(i)  deformation gradient [-] and first Piola stress [stress]: xx, xy, yx, yy, zz
//   M.moduli(i, j)      their symmetrized tangent dP_i/dF_j [stress]
//   M.plasticstraineq, M.stresseq, M.yielddistance (q/sigma_y - 1: positive outside the yield surface)
//   M.backstress(i)     back stress xx, yy, zz, xy of a law with kinematic hardening [stress]
//   M.internalvariables names of what the law keeps at a point: plastic_strain_eq, backstress
//   M.nodal(values)     a field over the points as one over the nodes;  M.points  how many points there are
//   M.displacement(i)   x, y over the nodes [length];  M.degree 1 or 2 of the elements;  M.Th their mesh
//   M.axisymmetric      1 or 0
#include "base/error.hpp"
#include "types.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"

namespace burnish {
namespace {

constexpr int GRADIENT = num_gradient<2>, STRESS = num_stress<2>;

struct NodalTag {};
struct StressTag {};
struct GradientTag {};
struct PiolaTag {};
struct BackstressTag {};
struct ModuliTag {};

KN_<double> nodal(Stack stack, const Method<MaterialHandle, NodalTag>& m, const KN_<double>& values) {
  return guarded([&] {
    return new_array(stack, nodal_average(m->get().workpiece().discretization(),
                                          to_vector(values, "material.nodal", "values")));
  });
}

// Component i of a point-major array with n components.
KN_<double> component(Stack stack, const std::vector<double>& all, long i, long n, const char* where) {
  require(i >= 0 && i < n, where, "component", i, ("0.." + std::to_string(n - 1)).c_str());
  const long points = static_cast<long>(all.size()) / n;
  auto* r = Add2StackOfPtr2FreeRC(stack, new KN<double>(points));
  for (long p = 0; p < points; ++p) (*r)[p] = all[p * n + i];
  return *r;
}
KN_<double> stress(Stack stack, const Method<MaterialHandle, StressTag>& m, const long& i) {
  return guarded(
      [&] { return component(stack, m->get().workpiece().state().stress, i, STRESS, "material.stress"); });
}
KN_<double> gradient(Stack stack, const Method<MaterialHandle, GradientTag>& m, const long& i) {
  return guarded([&] { return component(stack, m->get().workpiece().state().F, i, GRADIENT, "material.F"); });
}
KN_<double> piola(Stack stack, const Method<MaterialHandle, PiolaTag>& m, const long& i) {
  return guarded(
      [&] { return component(stack, piola_field(m->get().workpiece()), i, GRADIENT, "material.piola"); });
}
KN_<double> backstress(Stack stack, const Method<MaterialHandle, BackstressTag>& m, const long& i) {
  return guarded(
      [&] { return new_array(stack, m->get().workpiece().internal("backstress", static_cast<int>(i))); });
}
KN_<double> moduli(Stack stack, const Method<MaterialHandle, ModuliTag>& m, const long& i, const long& j) {
  return guarded([&] {
    constexpr int n = GRADIENT;
    require(i >= 0 && i < n && j >= 0 && j < n, "material.moduli", "index", i >= 0 && i < n ? j : i, "0..4");
    return component(stack, moduli_field(m->get().workpiece(), TangentKind::CONSISTENT), n * i + j, n * n,
                     "material.moduli");
  });
}
KN_<double> plastic_strain_eq(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_array(stack, h->get().workpiece().internal("plastic_strain_eq")); });
}
KN_<double> stress_eq(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_array(stack, stress_eq_field(h->get().workpiece())); });
}
KN_<double> yield_distance(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_array(stack, yield_distance_field(h->get().workpiece())); });
}
string* internal_variables(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_string(stack, h->get().workpiece().law().internal_variables().names()); });
}
struct DisplacementTag {};
KN_<double> displacement(Stack stack, const Method<MaterialHandle, DisplacementTag>& m, const long& i) {
  return guarded([&] {
    const Eigen::VectorXd& u = m->get().workpiece().state().displacement;
    return component(stack, std::vector<double>(u.data(), u.data() + u.size()), i, 2,
                     "material.displacement");
  });
}
long degree(MaterialHandle* const& h) {
  return guarded([&] { return h->get().workpiece().discretization().nodes_per_element == 3 ? 1L : 2L; });
}
long axisymmetric(MaterialHandle* const& h) {
  return guarded([&] { return h->get().workpiece().discretization().axisymmetric ? 1L : 0L; });
}
pmesh mesh_of_material(MaterialHandle* const& h) { return h->get().mesh.get(); }
long number_of_points(MaterialHandle* const& h) {
  return guarded([&] { return static_cast<long>(h->get().workpiece().discretization().num_points()); });
}

} // namespace

void register_material_data() {
  using H = MaterialHandle;
  add_method<H, NodalTag>(
      "nodal", [] { return new OneOperator2s_<KN_<double>, Method<H, NodalTag>, KN_<double>>(nodal); });
  add_method<H, StressTag>(
      "stress", [] { return new OneOperator2s_<KN_<double>, Method<H, StressTag>, long>(stress); });
  add_method<H, GradientTag>(
      "F", [] { return new OneOperator2s_<KN_<double>, Method<H, GradientTag>, long>(gradient); });
  add_method<H, PiolaTag>("piola",
                          [] { return new OneOperator2s_<KN_<double>, Method<H, PiolaTag>, long>(piola); });
  add_method<H, BackstressTag>("backstress", [] {
    return new OneOperator2s_<KN_<double>, Method<H, BackstressTag>, long>(backstress);
  });
  add_method<H, ModuliTag>(
      "moduli", [] { return new OneOperator3s_<KN_<double>, Method<H, ModuliTag>, long, long>(moduli); });
  Add<H*>("plasticstraineq", ".", new OneOperator1s_<KN_<double>, H*>(plastic_strain_eq));
  Add<H*>("stresseq", ".", new OneOperator1s_<KN_<double>, H*>(stress_eq));
  Add<H*>("internalvariables", ".", new OneOperator1s_<string*, H*>(internal_variables));
  Add<H*>("yielddistance", ".", new OneOperator1s_<KN_<double>, H*>(yield_distance));
  add_method<H, DisplacementTag>("displacement", [] {
    return new OneOperator2s_<KN_<double>, Method<H, DisplacementTag>, long>(displacement);
  });
  Add<H*>("degree", ".", new OneOperator1_<long, H*>(degree));
  Add<H*>("axisymmetric", ".", new OneOperator1_<long, H*>(axisymmetric));
  Add<H*>("Th", ".", new OneOperator1_<pmesh, H*>(mesh_of_material));
  Add<H*>("points", ".", new OneOperator1_<long, H*>(number_of_points));
}

} // namespace burnish
