// The profile of a tool, and what scripts read of it. Its lengths are numbers; a tool that grows has size= in t.coordinates.
// Closed: body outside; open: body on the left of the direction of travel. FreeFEM reads letters beyond ASCII in a path only
// from the command line: cad=getARGV("-cad", "").
//   tool(...)   parameters of the profile or surface; those of the kinds not chosen are refused. A profile alone is a tool of the
//       plane, everything else one of space. Without a word for it the axis is z of the tool's frame
//     circle=   roller about the origin of the tool's frame: its radius | length | | > 0
//     line=     straight line [x0, y0, x1, y1] from the first end to the second, body on the left | length | | two places
//     chain=    [x0, y0, r0, x1, y1, r1, ...]: lines from corner to corner, each with the radius of its fillet | length | |
//       r >= 0
//     closed=   chain: true: back to the first corner, body outside | | false
//     cad=      curves of a .geo, .step or .brep file, or faces of a .step or .brep file, exact, without facets; without a
//       folder: here, else beside the script. A file with faces out of the plane z = 0 is a tool of space, unless curves=,
//       revolve= or extrude= take its curves | | | a path
//     faces=    cad: numbers of the faces in the file, those of solids first, that make the tool. Faces join smoothly or the
//       surface ends at their edge: two that are named must join. The body is out of their solid; faces of none need inside= | - | all
//     scale=    cad: unit of length of the script over that of the file (STEP: over a mm) | - | 1 | > 0
//     curves=   cad: numbers of the curves in the file that make the profile | - | all
//     geo=      cad: numbers for a .geo file, "R=3; H=8" | | ""
//     sphere=   ball about the origin: its radius | length | | > 0
//     cylinder=   roller about the axis through the origin: its radius | length | | > 0
//     cone=     [R1, R2, height]: radii half the height below and above the origin, one of them may be 0, with flat ends | length | |
//       >= 0
//     torus=    [R, r]: radius of the circle of centers about the axis, and of the tube | length | | 0 < r < R
//     plane=    [x0, y0, z0, nx, ny, nz]: endless plane through a point, with the normal into the body | length, - | | six numbers
//     size=     plane: about the extent of the body on it, the lever arm for tolerances of moments | length | 1 | > 0
//     box=      [a, b, c]: lengths along x, y and z, about the origin | length | | > 0
//     revolve=   true: the profile is turned about the axis, its x is the distance from it and its y runs along it | | false
//     extrude=   true: the profile is swept along the axis; it lies in the x, y plane of the frame turned the shortest way from
//       z to the axis | | false
//     length=   cylinder, extrude: from end to end, half on each side of the origin, a closed profile with flat ends | length |
//       endless | > 0
//     fillet=   cylinder with length=, cone, box, extrude with length=: radius of all edges; a sharp one has no normal | length | |
//       > 0
//     axis=     cylinder, cone, torus, revolve, extrude: direction of the axis [x, y, z] | - | [0, 0, 1] | not all 0
//     inside=   true: the body on the other side, a circle is a hollow die; not with line= and plane= | | false
//     > tool die(chain=[-0.1, 0, 0, 0, 0, 5e-3, 0, -0.1, 0]);
//     > tool ball(sphere=5);
//     > tool punch(cylinder=25, length=80, fillet=4);
//     > tool block(cad="tests/support/cad/rounded.step", scale=1e-3);
//     > tool ring(chain=[60, 0, 0, 40, 0, 8, 40, -60, 0], revolve=true);
//     ! number of values in line
//     ! degrees without fillet; give it a radius > 0
//     ! no room for the fillets between
//     ! three per point: [x0,y0,r0, x1,y1,r1, ...]
//     ! ; swap the ends of a line to turn it
//     ! is sharp: give it
//     ! cannot have the radius
//     ! does not fit into the section at
//     ! and not at a right angle: a tip without normal
//     ! rounds the edges of the ends, and without length= there are none
//     ! rounds the edges of a closed profile, and this one is open
//     ! meet at a sharp edge
//     ! has a tip without normal at
//     ! has no side of its own
//     ! meet at one edge, at
//     ! has no face
//   rcShapes()   all kinds of profiles and surfaces with their parameters, a line each
//   t.outlinex(n), t.outliney(n)   in the plane: x, y of the outline where the tool is: n points and its joints | length
//     n         number of points | - | | 2 to 1000000
//   t.tightestradius   smallest radius of curvature, inf for lines | length
//   t.closest(x, y)   closest point of the profile: [x, y, gap, normal x, y, tangent x, y, curvature] | length, -, 1/length
//     x         place; gap < 0 inside the tool, the normal points out of it | length | | finite
//     y         place | length | | finite
//   t.closest(x, y, z)   the same of a surface in space: [x, y, z, gap, normal x, y, z, tangents x1, y1, z1, x2, y2, z2, curvatures
//       11, 12, 22 in them] | length, -, 1/length
//     x         place; gap < 0 inside the tool, the normal points out of it | length | | finite
//     y         place | length | | finite
//     z         place | length | | finite
//   t.closest(x, y, gap, nx, ny, curvature)   in the plane the same for arrays of points; returns the smallest gap | length
//       Beyond the end of an open tool the gap is the distance to that end
//     x         places | length | | finite
//     y         places | length | | as many as x
//     gap       out: gaps | length | | as many as x
//     nx        out: normals | - | | as many as x
//     ny        out: normals | - | | as many as x
//     curvature   out: curvatures | 1/length | | as many as x
#include "tool_shapes.hpp"
#include "arguments.hpp"
#include "base/error.hpp"
#include "kinematics/outline.hpp"
#include "kinematics/tool_foot.hpp"
#include "script_options.hpp"
#include "types.hpp"

namespace burnish {
namespace {

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> list = shape_parameters();
  return list;
}

// A function without arguments, which needs the stack for its text.
class ShapesHelp : public OneOperator {
  struct Text : E_F0 {
    AnyType operator()(Stack stack) const override {
      return SetAny<string*>(new_string(stack, shape_help()));
    }
  };

public:
  ShapesHelp() : OneOperator(map_type[typeid(string*).name()]) {}
  E_F0* code(const basicAC_F0&) const override { return new Text; }
};

struct OutlineXTag {};
struct OutlineYTag {};
KN_<double> outline_of(Stack stack, ToolHandle* handle, long n, int component) {
  return guarded([&] {
    DrivenTool<2>& tool =
        *of_dimension<2>(handle->get(), "tool.outline",
                         "; a tool of space has no outline, its surface is in the files of the run")
             .tool;
    const auto points = called("tool.outline", [&] { return outline(tool.tool(), tool.q(), n); });
    std::vector<double> values;
    for (const auto& x : points) values.push_back(x[component]);
    return new_array(stack, values);
  });
}
KN_<double> outline_x(Stack stack, const Method<ToolHandle, OutlineXTag>& m, const long& n) {
  return outline_of(stack, m.object, n, 0);
}
KN_<double> outline_y(Stack stack, const Method<ToolHandle, OutlineYTag>& m, const long& n) {
  return outline_of(stack, m.object, n, 1);
}

struct ClosestTag {};
using ClosestMethod = Method<ToolHandle, ClosestTag>;
// Feet of points on a tool of their dimension.
template <int Dim>
std::vector<ToolFoot<Dim>> feet_of(ToolHandle* handle, const std::vector<Vector<Dim>>& points) {
  const char* where = "tool.closest";
  const char* advice = Dim == 2 ? "; in space a point is x, y, z" : "; in the plane a point is x, y";
  for (const Vector<Dim>& x : points)
    for (int c = 0; c < Dim; ++c)
      require(std::isfinite(x[c]), where, std::string(1, "xyz"[c]).c_str(), x[c], "a finite number");
  auto& tool = *of_dimension<Dim>(handle->get(), where, advice).tool;
  return called(where, [&] { return tool_feet(tool.tool(), tool.q(), points); });
}
KN_<double> closest_to_point(Stack stack, const ClosestMethod& m, const double& x, const double& y) {
  return guarded([&] {
    const ToolFoot<2> f = feet_of<2>(m.object, {{x, y}}).front();
    return new_array(
        stack, std::vector<double>{f.x[0], f.x[1], f.gap, f.n[0], f.n[1], f.E(0, 0), f.E(1, 0), f.B(0, 0)});
  });
}
KN_<double> closest_in_space(Stack stack, const ClosestMethod& m, const double& x, const double& y,
                             const double& z) {
  return guarded([&] {
    const ToolFoot<3> f = feet_of<3>(m.object, {{x, y, z}}).front();
    std::vector<double> values(f.x.begin(), f.x.end());
    values.push_back(f.gap);
    values.insert(values.end(), f.n.begin(), f.n.end());
    for (int k = 0; k < 2; ++k) values.insert(values.end(), f.E.col(k).begin(), f.E.col(k).end());
    for (const double b : {f.B(0, 0), f.B(0, 1), f.B(1, 1)}) values.push_back(b);
    return new_array(stack, values);
  });
}
struct ClosestToPoints {
  using Array = KN_<double>;
  static const int n = 0;
  static basicAC_F0::name_and_type names[1];
  static double call(const Named&, const ClosestMethod& m, Array x, Array y, Array gap, Array nx, Array ny,
                     Array curvature) {
    const char* where = "tool.closest";
    const auto px = to_vector(x, where, "x"), py = to_vector(y, where, "y");
    const std::string size = std::to_string(x.N()) + ", the size of x";
    require(y.N() == x.N(), where, "size of y", y.N(), size.c_str());
    require(gap.N() == x.N(), where, "size of gap", gap.N(), size.c_str());
    require(nx.N() == x.N(), where, "size of nx", nx.N(), size.c_str());
    require(ny.N() == x.N(), where, "size of ny", ny.N(), size.c_str());
    require(curvature.N() == x.N(), where, "size of curvature", curvature.N(), size.c_str());
    std::vector<Vector<2>> points;
    for (long i = 0; i < x.N(); ++i) points.emplace_back(px[i], py[i]);
    double smallest = std::numeric_limits<double>::infinity();
    long i = 0;
    for (const ToolFoot<2>& foot : feet_of<2>(m.object, points)) {
      gap[i] = foot.gap;
      nx[i] = foot.n[0];
      ny[i] = foot.n[1];
      curvature[i++] = foot.B(0, 0);
      smallest = std::min(smallest, foot.gap);
    }
    return smallest;
  }
};
basicAC_F0::name_and_type ClosestToPoints::names[1];
double tightest_radius(ToolHandle* const& handle) {
  return on(handle, [](auto& object) {
    const auto& tool = object.tool->tool();
    return tool.coordinates().pose(object.tool->q()).size * tool.surface().tightest_radius();
  });
}

} // namespace

std::vector<basicAC_F0::name_and_type> shape_names(const std::vector<basicAC_F0::name_and_type>& more) {
  return names_of(parameters(), more);
}

AnySurface shape_of(const Named& named) {
  Arguments arguments = arguments_of(named, parameters());
  return called("tool", [&]() -> AnySurface {
    if (arguments.has("cad")) arguments.texts["cad"] = script_options().found(arguments.text("cad"));
    if (shape_dimension(arguments) == 3) return make_surface<3>(arguments);
    return make_surface<2>(arguments);
  });
}

void register_tool_shapes() {
  add_method<ToolHandle, OutlineXTag>("outlinex", [] {
    return new OneOperator2s_<KN_<double>, Method<ToolHandle, OutlineXTag>, long>(outline_x);
  });
  add_method<ToolHandle, OutlineYTag>("outliney", [] {
    return new OneOperator2s_<KN_<double>, Method<ToolHandle, OutlineYTag>, long>(outline_y);
  });
  using Array = KN_<double>;
  add_method<ToolHandle, ClosestTag>(
      "closest", [] { return new OneOperator3s_<Array, ClosestMethod, double, double>(closest_to_point); },
      [] { return new OneOperator4s_<Array, ClosestMethod, double, double, double>(closest_in_space); },
      [] {
        return new NamedOperator<ClosestToPoints, double, ClosestMethod, Array, Array, Array, Array, Array,
                                 Array>;
      });
  Global.Add("rcShapes", "(", new ShapesHelp);
  Add<ToolHandle*>("tightestradius", ".", new OneOperator1_<double, ToolHandle*>(tightest_radius));
}

} // namespace burnish
