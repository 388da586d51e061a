// The profile of a tool, and what scripts read of it. Arrays: inline, real[int] or int[int].
//   tool t(circle=R);  tool t(chain=[x0,y0,r0, x1,y1,r1, ...], closed=true);  tool t(cad="cam.step", scale=1e-3);
//                                              all kinds and parameters: cout << rcShapes(0), or the core's
//                                              geometry/shapes.hpp
//                                              FreeFEM reads letters beyond ASCII in a path only from the
//                                              command line: cad=getARGV("-cad", "")
//   closed: body outside; open: body on the left of the direction of travel; inside=true swaps
//   t.outlinex(n), t.outliney(n)               outline of the tool where it is, n points and its joints
//   t.tightestradius                           smallest radius of curvature; inf for lines
#include "tool_shapes.hpp"
#include "arguments.hpp"
#include "kinematics/outline.hpp"
#include "types.hpp"

namespace burnish {
namespace {

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> list = shape_parameters();
  return list;
}

string* help(Stack stack, const long&) { return new_string(stack, shape_help()); }

struct OutlineXTag {};
struct OutlineYTag {};
KN_<double> outline_of(Stack stack, ToolHandle* handle, long n, int component) {
  return guarded([&] {
    DrivenTool<2>& tool = *handle->get().tool;
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
double tightest_radius(ToolHandle* const& handle) {
  return guarded([&] { return handle->get().tool->tool().surface().tightest_radius(); });
}

} // namespace

std::vector<basicAC_F0::name_and_type> shape_names(const std::vector<basicAC_F0::name_and_type>& more) {
  return names_of(parameters(), more);
}

std::shared_ptr<const Profile<2>> shape_of(const Named& named) {
  const Arguments arguments = arguments_of(named, parameters());
  return called("tool", [&] { return make_shape(arguments); });
}

void register_tool_shapes() {
  add_method<ToolHandle, OutlineXTag>("outlinex", [] {
    return new OneOperator2s_<KN_<double>, Method<ToolHandle, OutlineXTag>, long>(outline_x);
  });
  add_method<ToolHandle, OutlineYTag>("outliney", [] {
    return new OneOperator2s_<KN_<double>, Method<ToolHandle, OutlineYTag>, long>(outline_y);
  });
  Global.Add("rcShapes", "(", new OneOperator1s_<string*, long>(help));
  Add<ToolHandle*>("tightestradius", ".", new OneOperator1_<double, ToolHandle*>(tightest_radius));
}

} // namespace burnish
