// Tensors at the quadrature points (order and place of the points: material_data.cpp), read and, where the script owns
// the law, given. A user-defined law is asked for after each M.update, which moves the points only. Arrays hold one number
// per point; numbers that are not finite are refused with the point. Components in the plane: of symmetric tensors 0 xx, 1 yy,
// 2 zz, 3 xy, of gradients 0 xx, 1 xy, 2 yx, 3 yy, 4 zz; in space: 0 xx, 1 yy, 2 zz, 3 xy, 4 yz, 5 zx, and 0 xx, 1 xy, ... 8 zz.
//   M.userdefined(on)   whether the script owns the law, from now on (always with rcMaterial(Vh, law="user"))
//     on        true or false
//   M.userdefined()   whether it does
//   M.stress(i)   Kirchhoff stress; with damage of a user-defined law that of the law, which its points carry in part | stress
//     i         0 xx, 1 yy, 2 zz, 3 xy; in space also 4 yz, 5 zx | - | | 0 to 3; in space to 5
//   M.stress(i, a)   gives it
//     i         component | - | | 0 to 3; in space to 5
//     a         one per point | stress | | finite
//     ! the law of this material is not user-defined, nothing can be given
//     ! there was no update since the last accepted state, call update first
//   M.cauchy(i)   Cauchy stress, M.stress over the determinant of F; with small strains M.stress | stress
//     i         0 xx, 1 yy, 2 zz, 3 xy; in space also 4 yz, 5 zx | - | | 0 to 3; in space to 5
//   M.piola(i)   first Piola stress | stress
//     i         0 xx, 1 xy, 2 yx, 3 yy, 4 zz; in space 0 xx, 1 xy, 2 xz, 3 yx, ... 8 zz | - | | 0 to 4; in space to 8
//   M.piola(i, a)   gives it, in place of M.stress
//     i         component | - | | 0 to 4; in space to 8
//     a         one per point | stress | | finite
//   M.moduli(i, j)   dP_i/dF_j, symmetrized | stress
//     i         component of P | - | | 0 to 4; in space to 8
//     j         component of F | - | | 0 to 4; in space to 8
//   M.moduli(i, j, value)   the same with a part of elastic moduli in plastic points, or, with an array, gives them; (i, j)
//       stands for (j, i), too | stress
//     i         component of P | - | | 0 to 4; in space to 8
//     j         component of F | - | | 0 to 4; in space to 8
//     value     real: part of elastic moduli; array: dP_i/dF_j | -, stress
//   M.jacobian(i, j, a)   gives d tau_i/d y_j, y = M.strain(0..3), M.rotation, in space M.strain(0..5) and the spins about x, y, z
//       (METHOD.md 1.16), in place of M.moduli
//     i         component of the stress | - | | 0 to 3; in space to 5
//     j         component of y | - | | 0 to 4; in space to 8
//     a         one per point | stress | | finite
//   M.internal(name)   internal variable, component 0 | its own
//     name      one of M.internalvariables
//   M.internal(name, i)   its component i, or, with an array, gives component 0
//     name      one of M.internalvariables
//     i         component, or values, one per point | - | | 0 to number of components - 1
//   M.internal(name, i, a)   gives component i
//     name      one of M.internalvariables
//     i         component | -
//     a         one per point | its own | | finite
//   M.backstress(i)   back stress of a law with kinematic hardening | stress
//     i         0 xx, 1 yy, 2 zz, 3 xy; in space also 4 yz, 5 zx | - | | 0 to 3; in space to 5
//   M.F(i)      deformation gradient | -
//     i         0 xx, 1 xy, 2 yx, 3 yy, 4 zz; in space 0 xx, 1 xy, 2 xz, 3 yx, ... 8 zz | - | | 0 to 4; in space to 8
//   M.strain(i)   strain increment of the step | -
//     i         0 xx, 1 yy, 2 zz, 3 xy; in space also 4 yz, 5 zx | - | | 0 to 3; in space to 5
//   M.rotation   in the plane: rotation increment of the step | rad
//   M.rotationvector(i)   in space: the same, component of a vector along its axis | rad
//     i         0 x, 1 y, 2 z | - | | 0 to 2
//   M.modulus(name)   constant of the law | stress, -
//     name      "K", "G": elasticity; "C", "gamma": back stress
//   M.yieldstress(ep), M.hardeningslope(ep)   of its hardening | stress
//     ep        accumulated plastic strains | - | | finite
//   M.vertexvalues(a)   the linear function of every element with the values a at its points, as a field of P1dc (P1: of P0)
//     a         one per point | its own | | finite
#include "base/error.hpp"
#include "types.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"

namespace burnish {
namespace {

using M = MaterialHandle;
using Array = KN_<double>;
constexpr double P1DC_PLACES = 0.99; // degrees of freedom of FreeFEM's P1dc, of the way to the vertices

struct StressTag {};
struct GradientTag {};
struct CauchyTag {};
struct PiolaTag {};
struct ModuliTag {};
struct JacobianTag {};
struct InternalTag {};
struct StrainTag {};
struct RotationTag {};
struct UserTag {};
struct BackstressTag {};
struct ModulusTag {};
struct YieldTag {};
struct SlopeTag {};
struct VertexTag {};

// Component i of a point-major array with n components.
Array component(Stack stack, const std::vector<double>& all, long i, long n, const char* where) {
  require(i >= 0 && i < n, where, "component", i, ("0.." + std::to_string(n - 1)).c_str());
  const long points = static_cast<long>(all.size()) / n;
  auto* r = Add2StackOfPtr2FreeRC(stack, new KN<double>(points));
  for (long p = 0; p < points; ++p) (*r)[p] = all[p * n + i];
  return *r;
}
int component_index(long i, const char* where) {
  require(i >= 0 && i < 1000, where, "component", i, "0 or more, see the list of components");
  return static_cast<int>(i);
}
template <class Give> bool give(M* handle, const char* where, const Give& f) {
  return on(handle, [&](auto& material) {
    const CpuTimer timer(material.update_seconds);
    f(material.changed().workpiece().given(where));
    return true;
  });
}
// Component i of what the field of a workpiece gives, n of them in its dimension.
template <class Field> Array component_of(Stack stack, M* handle, long i, const char* where, Field field) {
  return on(handle, [&](auto& material) {
    const std::vector<double>& all = field(material.workpiece());
    const long points = material.workpiece().discretization().num_points();
    return component(stack, all, i, static_cast<long>(all.size()) / std::max(points, 1L), where);
  });
}

Array stress(Stack stack, const Method<M, StressTag>& m, const long& i) {
  return component_of(stack, m.object, i, "material.stress",
                      [](const auto& body) { return script_stress_field(body); });
}
bool give_stress(const Method<M, StressTag>& m, const long& i, const Array& a) {
  return give(m.object, "material.stress",
              [&](const auto& given) { given.stress(component_index(i, "material.stress"), values_of(a)); });
}
Array cauchy(Stack stack, const Method<M, CauchyTag>& m, const long& i) {
  return component_of(stack, m.object, i, "material.cauchy",
                      [](const auto& body) { return cauchy_field(body); });
}
Array gradient(Stack stack, const Method<M, GradientTag>& m, const long& i) {
  return component_of(stack, m.object, i, "material.F", [](const auto& body) { return body.state().F; });
}
Array piola(Stack stack, const Method<M, PiolaTag>& m, const long& i) {
  return component_of(stack, m.object, i, "material.piola",
                      [](const auto& body) { return piola_field(body); });
}
bool give_piola(const Method<M, PiolaTag>& m, const long& i, const Array& a) {
  return give(m.object, "material.piola",
              [&](const auto& given) { given.piola(component_index(i, "material.piola"), values_of(a)); });
}
// All moduli are made at once: a script reads one component after the other.
template <int Dim> const std::vector<double>& all_moduli(MaterialOf<Dim>& object, double blend) {
  if (object.moduli_blend == blend) return object.moduli;
  object.moduli = moduli_field(object.workpiece(), TangentKind::CONSISTENT, blend);
  object.moduli_blend = blend;
  return object.moduli;
}
Array blended_moduli(Stack stack, const Method<M, ModuliTag>& m, const long& i, const long& j,
                     const double& blend) {
  return on(m.object, [&](auto& material) {
    constexpr int n = num_gradient<dim_of<decltype(material)>>;
    require(i >= 0 && i < n && j >= 0 && j < n, "material.moduli", "index", i >= 0 && i < n ? j : i,
            ("0.." + std::to_string(n - 1)).c_str());
    return component(stack, all_moduli(material, blend), n * i + j, n * n, "material.moduli");
  });
}
Array moduli(Stack stack, const Method<M, ModuliTag>& m, const long& i, const long& j) {
  return blended_moduli(stack, m, i, j, 0);
}
bool give_moduli(Stack, const Method<M, ModuliTag>& m, const long& i, const long& j, const Array& a) {
  return give(m.object, "material.moduli", [&](const auto& given) {
    given.moduli(static_cast<int>(i), static_cast<int>(j), values_of(a));
  });
}
bool give_jacobian(Stack, const Method<M, JacobianTag>& m, const long& i, const long& j, const Array& a) {
  return give(m.object, "material.jacobian", [&](const auto& given) {
    given.jacobian(static_cast<int>(i), static_cast<int>(j), values_of(a));
  });
}
Array internal_component(Stack stack, const Method<M, InternalTag>& m, string* const& name, const long& i) {
  return on(m.object, [&](auto& material) {
    return new_array(stack, internal_field(material.workpiece(), *name, static_cast<int>(i)));
  });
}
Array internal(Stack stack, const Method<M, InternalTag>& m, string* const& name) {
  return internal_component(stack, m, name, 0);
}
bool give_internal_component(Stack, const Method<M, InternalTag>& m, string* const& name, const long& i,
                             const Array& a) {
  return give(m.object, "material.internal",
              [&](const auto& given) { given.internal(*name, static_cast<int>(i), values_of(a)); });
}
bool give_internal(const Method<M, InternalTag>& m, string* const& name, const Array& a) {
  return give_internal_component(nullptr, m, name, 0, a);
}
Array backstress(Stack stack, const Method<M, BackstressTag>& m, const long& i) {
  return on(m.object, [&](auto& material) {
    return new_array(stack, internal_field(material.workpiece(), "backstress", static_cast<int>(i)));
  });
}
Array strain(Stack stack, const Method<M, StrainTag>& m, const long& i) {
  return component_of(stack, m.object, i, "material.strain",
                      [](const auto& body) { return body.state().strain_increment; });
}
Array rotation(Stack stack, M* const& h) {
  return guarded([&] {
    const char* advice = "; in space it is M.rotationvector(i)";
    const auto& body = of_dimension<2>(h->get(), "material.rotation", advice).workpiece();
    return component(stack, increments_field(body), num_increments<2> - 1, num_increments<2>,
                     "material.rotation");
  });
}
Array rotation_vector(Stack stack, const Method<M, RotationTag>& m, const long& i) {
  return guarded([&] {
    const char* where = "material.rotationvector";
    const auto& body = of_dimension<3>(m->get(), where, "; in the plane it is M.rotation").workpiece();
    require(i >= 0 && i < 3, where, "component", i, "0..2");
    return component(stack, increments_field(body), num_stress<3> + i, num_increments<3>, where);
  });
}
bool user_defined(const Method<M, UserTag>& m, const bool& on) {
  return burnish::on(m.object, [&](auto& material) { return material.workpiece().set_user_defined(on), on; });
}
bool is_user_defined(const Method<M, UserTag>& m) {
  return on(m.object, [](auto& material) { return material.workpiece().user_defined(); });
}
double modulus(const Method<M, ModulusTag>& m, string* const& name) {
  return on(m.object, [&](auto& material) { return material.workpiece().law().modulus(*name); });
}
Array yield_stress(Stack stack, const Method<M, YieldTag>& m, const Array& ep) {
  return on(m.object, [&](auto& material) {
    return new_array(stack, yield_stress_field(material.workpiece(),
                                               to_vector(ep, "material.yieldstress", "plastic strain")));
  });
}
Array hardening_slope(Stack stack, const Method<M, SlopeTag>& m, const Array& ep) {
  return on(m.object, [&](auto& material) {
    return new_array(stack,
                     hardening_slope_field(material.workpiece(),
                                           to_vector(ep, "material.hardeningslope", "plastic strain")));
  });
}
Array at_vertices(Stack stack, const Method<M, VertexTag>& m, const Array& a) {
  return guarded([&] {
    const char* where = "material.vertexvalues";
    const char* advice = "; in space numbers at the points are a field of P0 or FEQF23d as they are";
    return new_array(stack,
                     vertex_values(of_dimension<2>(m->get(), where, advice).workpiece().discretization(),
                                   to_vector(a, where, "values"), P1DC_PLACES));
  });
}

} // namespace

void register_material_points() {
  add_method<M, StressTag>(
      "stress", [] { return new OneOperator2s_<Array, Method<M, StressTag>, long>(stress); },
      [] { return new OneOperator3_<bool, Method<M, StressTag>, long, Array>(give_stress); });
  add_method<M, CauchyTag>("cauchy",
                           [] { return new OneOperator2s_<Array, Method<M, CauchyTag>, long>(cauchy); });
  add_method<M, GradientTag>(
      "F", [] { return new OneOperator2s_<Array, Method<M, GradientTag>, long>(gradient); });
  add_method<M, PiolaTag>(
      "piola", [] { return new OneOperator2s_<Array, Method<M, PiolaTag>, long>(piola); },
      [] { return new OneOperator3_<bool, Method<M, PiolaTag>, long, Array>(give_piola); });
  add_method<M, ModuliTag>(
      "moduli", [] { return new OneOperator3s_<Array, Method<M, ModuliTag>, long, long>(moduli); },
      [] { return new OneOperator4s_<Array, Method<M, ModuliTag>, long, long, double>(blended_moduli); },
      [] { return new OneOperator4s_<bool, Method<M, ModuliTag>, long, long, Array>(give_moduli); });
  add_method<M, JacobianTag>("jacobian", [] {
    return new OneOperator4s_<bool, Method<M, JacobianTag>, long, long, Array>(give_jacobian);
  });
  add_method<M, InternalTag>(
      "internal", [] { return new OneOperator2s_<Array, Method<M, InternalTag>, string*>(internal); },
      [] { return new OneOperator3s_<Array, Method<M, InternalTag>, string*, long>(internal_component); },
      [] { return new OneOperator3_<bool, Method<M, InternalTag>, string*, Array>(give_internal); },
      [] {
        return new OneOperator4s_<bool, Method<M, InternalTag>, string*, long, Array>(
            give_internal_component);
      });
  add_method<M, BackstressTag>(
      "backstress", [] { return new OneOperator2s_<Array, Method<M, BackstressTag>, long>(backstress); });
  add_method<M, StrainTag>("strain",
                           [] { return new OneOperator2s_<Array, Method<M, StrainTag>, long>(strain); });
  add_method<M, UserTag>(
      "userdefined", [] { return new OneOperator2_<bool, Method<M, UserTag>, bool>(user_defined); },
      [] { return new OneOperator1_<bool, Method<M, UserTag>>(is_user_defined); });
  add_method<M, ModulusTag>(
      "modulus", [] { return new OneOperator2_<double, Method<M, ModulusTag>, string*>(modulus); });
  add_method<M, YieldTag>("yieldstress",
                          [] { return new OneOperator2s_<Array, Method<M, YieldTag>, Array>(yield_stress); });
  add_method<M, SlopeTag>("hardeningslope", [] {
    return new OneOperator2s_<Array, Method<M, SlopeTag>, Array>(hardening_slope);
  });
  add_method<M, VertexTag>(
      "vertexvalues", [] { return new OneOperator2s_<Array, Method<M, VertexTag>, Array>(at_vertices); });
  Add<M*>("rotation", ".", new OneOperator1s_<Array, M*>(rotation));
  add_method<M, RotationTag>("rotationvector", [] {
    return new OneOperator2s_<Array, Method<M, RotationTag>, long>(rotation_vector);
  });
}

} // namespace burnish
