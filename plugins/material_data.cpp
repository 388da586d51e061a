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
//     i         0: x, 1: y, 2: z | - | | 0, 1; 2 in space
//   M.degree    of the elements: 1 or 2 | -
//   M.Th, M.Th3   their mesh, in the plane and in space
//   M.displaced(places)   in space: that mesh, with its surface .Gamma, its vertices elsewhere, for FreeFEM's plot; in the plane movemesh
//       does it
//     places    x, y, z of each vertex, a column each, real[int, int] | length | | 3 rows
//   M.dimension   2 or 3 | -
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
  return on(m.object, [&](auto& material) {
    return new_array(stack, nodal_average(material.workpiece().discretization(),
                                          to_vector(values, "material.nodal", "values")));
  });
}

KN_<double> plastic_strain_eq(Stack stack, MaterialHandle* const& h) {
  return on(h, [&](auto& material) {
    return new_array(stack, internal_field(material.workpiece(), "plastic_strain_eq"));
  });
}
KN_<double> stress_eq(Stack stack, MaterialHandle* const& h) {
  return on(h, [&](auto& material) { return new_array(stack, stress_eq_field(material.workpiece())); });
}
KN_<double> yield_distance(Stack stack, MaterialHandle* const& h) {
  return on(h, [&](auto& material) { return new_array(stack, yield_distance_field(material.workpiece())); });
}
KN_<double> stress_error_field(Stack stack, MaterialHandle* const& h) {
  return on(h, [&](auto& material) {
    const auto& workpiece = material.workpiece();
    return new_array(stack, stress_error(workpiece.discretization(), stress_field(workpiece)).point);
  });
}
struct PercentileTag {};
double percentile(const Method<MaterialHandle, PercentileTag>& m, const KN_<double>& values,
                  const double& share, const double& least) {
  return on(m.object, [&](auto& material) {
    return called("material.volumepercentile", [&] {
      return volume_percentile(material.workpiece().discretization(),
                               to_vector(values, "material.volumepercentile", "values"), share, least);
    });
  });
}
string* internal_variables(Stack stack, MaterialHandle* const& h) {
  return on(h, [&](auto& material) {
    return new_string(stack, material.workpiece().law().internal_variables().names());
  });
}
struct DisplacementTag {};
KN_<double> displacement(Stack stack, const Method<MaterialHandle, DisplacementTag>& m, const long& i) {
  return on(m.object, [&](auto& material) {
    constexpr int Dim = dim_of<decltype(material)>;
    require(i >= 0 && i < Dim, "material.displacement", "component", i, Dim == 2 ? "0 or 1" : "0, 1 or 2");
    const Eigen::VectorXd& u = material.workpiece().state().displacement;
    return new_array(stack, Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<Dim>>(
                                u.data() + i, u.size() / Dim)));
  });
}
long degree(MaterialHandle* const& h) {
  return on(h, [](auto& material) {
    return material.workpiece().discretization().nodes_per_element == dim_of<decltype(material)> + 1 ? 1L
                                                                                                     : 2L;
  });
}
long axisymmetric(MaterialHandle* const& h) {
  return on(h, [](auto& material) { return material.workpiece().discretization().axisymmetric ? 1L : 0L; });
}
pmesh plane_mesh(MaterialHandle* const& h) {
  return guarded(
      [&] { return of_dimension<2>(h->get(), "material.Th", "; in space it is M.Th3").mesh.get(); });
}
pmesh3 mesh_in_space(MaterialHandle* const& h) {
  return guarded(
      [&] { return of_dimension<3>(h->get(), "material.Th3", "; in the plane it is M.Th").mesh.get(); });
}
struct DisplacedTag {};
// A new mesh of the same elements; it goes with the stack.
pmesh3 displaced_mesh(Stack stack, const ::Mesh3& mesh, const KNM<double>& to) {
  using namespace Fem2D;
  auto* places = new Vertex3[mesh.nv];
  auto* elements = new Tet[mesh.nt];
  auto* faces = new Triangle3[mesh.nbe];
  for (int i = 0; i < mesh.nv; ++i) {
    static_cast<R3&>(places[i]) = R3(to(0, i), to(1, i), to(2, i));
    places[i].lab = mesh.vertices[i].lab;
  }
  for (int k = 0; k < mesh.nt; ++k) {
    int corners[] = {mesh(k, 0), mesh(k, 1), mesh(k, 2), mesh(k, 3)};
    elements[k].set(places, corners, mesh[k].lab);
  }
  for (int b = 0; b < mesh.nbe; ++b) {
    const Triangle3& face = mesh.be(b);
    int corners[] = {mesh(face[0]), mesh(face[1]), mesh(face[2])};
    faces[b].set(places, corners, face.lab);
  }
  auto* moved = new ::Mesh3(mesh.nv, mesh.nt, mesh.nbe, places, elements, faces);
  moved->BuildMeshS();
  return Add2StackOfPtr2FreeRC(stack, moved);
}
pmesh3 displaced(Stack stack, const Method<MaterialHandle, DisplacedTag>& m, KNM<double>* const& places) {
  return guarded([&] {
    constexpr const char* where = "material.displaced";
    const ::Mesh3& mesh =
        *of_dimension<3>(m->get(), where, "; in the plane movemesh(M.Th, ...) does it").mesh;
    require(places->N() == 3, where, "rows of the places", places->N(), "3: x, y, z");
    require(places->M() == mesh.nv, where, "columns of the places", places->M(),
            (std::to_string(mesh.nv) + ", one for each vertex").c_str());
    return displaced_mesh(stack, mesh, *places);
  });
}
long dimension(MaterialHandle* const& h) {
  return guarded([&] { return static_cast<long>(h->get().dimension); });
}
long number_of_points(MaterialHandle* const& h) {
  return on(h, [](auto& material) {
    return static_cast<long>(material.workpiece().discretization().num_points());
  });
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
  Add<H*>("Th", ".", new OneOperator1_<pmesh, H*>(plane_mesh));
  Add<H*>("Th3", ".", new OneOperator1_<pmesh3, H*>(mesh_in_space));
  add_method<H, DisplacedTag>("displaced", [] {
    return new OneOperator2s_<pmesh3, Method<H, DisplacedTag>, KNM<double>*>(displaced);
  });
  Add<H*>("dimension", ".", new OneOperator1_<long, H*>(dimension));
  Add<H*>("points", ".", new OneOperator1_<long, H*>(number_of_points));
}

} // namespace burnish
