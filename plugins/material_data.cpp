// What a script reads of a material, as arrays over the quadrature points: element by element; P1 its centroid (P0), P2
// the middles of the edges opposite vertex 0, 1, 2 (FEQF2) or, axisymmetric, the inner points nearest to vertex 0, 1, 2,
// with barycentric coordinate 2/3 there and 1/6 at the others. zz is the hoop direction when axisymmetric. Tensors:
// material_points.cpp
//   M.plasticstraineq   accumulated plastic strain | -
//   M.stresseq   von Mises stress | stress
//   M.yielddistance   q/sigma_y - 1: positive outside the yield surface | -
//   M.internalvariables   names of what the law keeps at a point: "plastic_strain_eq,backstress"
//   M.nodal(values)   a field over the points as one over the nodes | its own
//     values    one per point | its own | | finite
//   M.points    number of quadrature points | -
//   M.stresserror   how far the stress is from its recovery at the nodes, Frobenius norm | stress
//   M.volumepercentile(values, share, least)   value below which that share of the volume lies | its own
//     values    one per point | its own
//     share     of the volume | - | | 0 to 1
//     least     points below it do not count | its own
//   M.displacement(i)   component over the nodes, accepted state | length
//     i         0: x, 1: y | - | | 0, 1
//   M.degree    of the elements: 1 or 2 | -
//   M.Th        their mesh
//   M.axisymmetric   1 or 0 | -
//   M.warnings   one line for each number that no known material has
#include "base/error.hpp"
#include "types.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/stress_error.hpp"
#include "workpiece/volume_percentile.hpp"

namespace burnish {
namespace {

struct NodalTag {};

KN_<double> nodal(Stack stack, const Method<MaterialHandle, NodalTag>& m, const KN_<double>& values) {
  return guarded([&] {
    return new_array(stack, nodal_average(m->get().workpiece().discretization(),
                                          to_vector(values, "material.nodal", "values")));
  });
}

KN_<double> plastic_strain_eq(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_array(stack, internal_field(h->get().workpiece(), "plastic_strain_eq")); });
}
KN_<double> stress_eq(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_array(stack, stress_eq_field(h->get().workpiece())); });
}
KN_<double> yield_distance(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_array(stack, yield_distance_field(h->get().workpiece())); });
}
KN_<double> stress_error_field(Stack stack, MaterialHandle* const& h) {
  return guarded([&] {
    const Workpiece<2>& workpiece = h->get().workpiece();
    return new_array(stack, stress_error(workpiece.discretization(), stress_field(workpiece)).point);
  });
}
struct PercentileTag {};
double percentile(const Method<MaterialHandle, PercentileTag>& m, const KN_<double>& values,
                  const double& share, const double& least) {
  return guarded([&] {
    return called("material.volumepercentile", [&] {
      return volume_percentile(m->get().workpiece().discretization(),
                               to_vector(values, "material.volumepercentile", "values"), share, least);
    });
  });
}
string* internal_variables(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_string(stack, h->get().workpiece().law().internal_variables().names()); });
}
struct DisplacementTag {};
KN_<double> displacement(Stack stack, const Method<MaterialHandle, DisplacementTag>& m, const long& i) {
  return guarded([&] {
    require(i >= 0 && i < 2, "material.displacement", "component", i, "0 or 1");
    const Eigen::VectorXd& u = m->get().workpiece().state().displacement;
    return new_array(stack, Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>>(
                                u.data() + i, u.size() / 2)));
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

string* material_warnings(Stack stack, MaterialHandle* const& h) {
  return guarded([&] { return new_string(stack, h->get().warnings); });
}

} // namespace

void register_material_data() {
  using H = MaterialHandle;
  add_method<H, NodalTag>(
      "nodal", [] { return new OneOperator2s_<KN_<double>, Method<H, NodalTag>, KN_<double>>(nodal); });
  add_method<H, PercentileTag>("volumepercentile", [] {
    return new OneOperator4_<double, Method<H, PercentileTag>, KN_<double>, double, double>(percentile);
  });
  Add<H*>("stresserror", ".", new OneOperator1s_<KN_<double>, H*>(stress_error_field));
  Add<H*>("plasticstraineq", ".", new OneOperator1s_<KN_<double>, H*>(plastic_strain_eq));
  Add<H*>("stresseq", ".", new OneOperator1s_<KN_<double>, H*>(stress_eq));
  Add<H*>("internalvariables", ".", new OneOperator1s_<string*, H*>(internal_variables));
  Add<H*>("yielddistance", ".", new OneOperator1s_<KN_<double>, H*>(yield_distance));
  add_method<H, DisplacementTag>("displacement", [] {
    return new OneOperator2s_<KN_<double>, Method<H, DisplacementTag>, long>(displacement);
  });
  Add<H*>("warnings", ".", new OneOperator1s_<string*, H*>(material_warnings));
  Add<H*>("degree", ".", new OneOperator1_<long, H*>(degree));
  Add<H*>("axisymmetric", ".", new OneOperator1_<long, H*>(axisymmetric));
  Add<H*>("Th", ".", new OneOperator1_<pmesh, H*>(mesh_of_material));
  Add<H*>("points", ".", new OneOperator1_<long, H*>(number_of_points));
}

} // namespace burnish
