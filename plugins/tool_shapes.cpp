// The profile of a tool, and what scripts read of it. Arrays: inline, real[int] or int[int].
//   tool t(chain=[x0,y0,r0, x1,y1,r1, ...]);   lines joined by fillets: corners, radii (0 at both ends);
//                                              closed=true
//   tool t(cad="cam.step", scale=1e-3);        .geo .step .stp .brep; curves=[3,4]; geo="R=2; H=8" gives
//                                              numbers to the DefineConstants of a .geo file
//                                              FreeFEM reads letters beyond ASCII in a path only from the
//                                              command line: cad=getARGV("-cad", "")
//   closed: body outside; open: body on the left of the direction of travel; inside=true swaps
//   t.outlinex(n), t.outliney(n)               outline of the tool where it is, n points and its joints
//   t.tightestradius                           smallest radius of curvature; inf for lines
#include "tool_shapes.hpp"
#include "base/error.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/cad_curve.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/outline.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using Shape = std::shared_ptr<const Profile<2>>;

Shape circle(const Named& named) {
  return std::make_shared<Circle>(named.real("circle", 0), named.boolean("inside", false));
}

Shape line(const Named& named) {
  const std::vector<double> p = named.numbers("line");
  require(p.size() == 4, "tool", "number of values in line", p.size(), "4: [x0,y0,x1,y1]");
  return std::make_shared<Segment>(Vector<2>(p[0], p[1]), Vector<2>(p[2], p[3]));
}

Shape chain(const Named& named) {
  const std::vector<double> p = named.numbers("chain");
  require(p.size() % 3 == 0 && !p.empty(), "tool", "number of values in chain", p.size(),
          "three per point: [x0,y0,r0, x1,y1,r1, ...]");
  std::vector<Vector<2>> points;
  std::vector<double> radii;
  for (std::size_t i = 0; i < p.size(); i += 3) {
    points.emplace_back(p[i], p[i + 1]);
    radii.push_back(p[i + 2]);
  }
  return called("tool", [&] {
    return std::make_shared<ArcChain>(points, radii, named.boolean("closed", false),
                                      named.boolean("inside", false));
  });
}

Shape cad(const Named& named) {
  CadSelection selection;
  selection.file = named.text("cad", "");
  if (named.has("curves")) {
    const std::vector<double> tags = named.numbers("curves");
    if (tags.empty()) fail("tool", "curves is an empty array: name curves, or leave it out to take all");
    for (const double tag : tags) {
      require(tag == std::round(tag) && std::abs(tag) < 1e9, "tool", "tag in curves", tag, "an integer");
      selection.curves.push_back(static_cast<int>(tag));
    }
  }
  selection.scale = named.real("scale", 1);
  selection.numbers = named.text("geo", "");
  selection.inside = named.boolean("inside", false);
  return called("tool", [&] { return std::make_shared<CadCurve>(selection); });
}

struct Kind {
  const char* name;
  Shape (*make)(const Named&);
  std::vector<std::string> takes;
};
const Kind KINDS[] = {{"circle", circle, {"inside"}},
                      {"line", line, {}},
                      {"chain", chain, {"closed", "inside"}},
                      {"cad", cad, {"curves", "scale", "geo", "inside"}}};

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

Shape shape_of(const Named& named) {
  const Kind* chosen = nullptr;
  int count = 0;
  for (const Kind& kind : KINDS)
    if (named.has(kind.name)) {
      chosen = &kind;
      ++count;
    }
  if (count != 1)
    fail("tool", "give exactly one profile: circle=R, line=[x0,y0,x1,y1], chain=[x0,y0,r0, x1,y1,r1, "
                 "...] or cad=\"file\"");
  for (const char* option : {"closed", "curves", "scale", "geo", "inside"})
    if (named.has(option) &&
        std::find(chosen->takes.begin(), chosen->takes.end(), option) == chosen->takes.end())
      fail("tool", std::string(chosen->name) + "= takes no " + option + "=" +
                       (chosen->make == line ? "; swap the ends of a line to turn it" : ""));
  return chosen->make(named);
}

void register_tool_shapes() {
  add_method<ToolHandle, OutlineXTag>("outlinex", [] {
    return new OneOperator2s_<KN_<double>, Method<ToolHandle, OutlineXTag>, long>(outline_x);
  });
  add_method<ToolHandle, OutlineYTag>("outliney", [] {
    return new OneOperator2s_<KN_<double>, Method<ToolHandle, OutlineYTag>, long>(outline_y);
  });
  Add<ToolHandle*>("tightestradius", ".", new OneOperator1_<double, ToolHandle*>(tightest_radius));
}

} // namespace burnish
