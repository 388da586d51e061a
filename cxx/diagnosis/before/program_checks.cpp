#include "diagnosis/before/program_checks.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "contact/tool_support.hpp"
#include "diagnosis/before/wrong_side.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int SAMPLES = 32; // of a closed tool's surface, to tell whether it lies in the body
constexpr double INSIDE =
    1e-3; // penetration at the start that does not count, over the spacing of candidates

template <int Dim> std::string coordinate(const DrivenTool<Dim>& tool, Eigen::Index k) {
  const std::string& name = tool.tool().coordinates().names()[static_cast<std::size_t>(k)];
  return "coordinate \"" + name + "\" of tool \"" + tool.name() + "\"";
}

// Whether a closed tool lies between the nodes altogether, at the reference place of the workpiece.
template <int Dim>
bool within_body(const ContactSetup<Dim>& setup, const MeshLocator<Dim>& locator,
                 const ContactState<Dim>& state, int tool) {
  const auto& surface = setup.model().tools[tool]->surface();
  if (!surface.closed()) return false;
  const auto pose = setup.model().tools[tool]->coordinates().pose(setup.model().tool_q(state.q, tool));
  for (const auto& place : surface.samples(SAMPLES))
    if (locator.find(setup.model().tools[tool]->position(pose, place), setup.candidates()[0], 0) < 0)
      return false;
  return true;
}

} // namespace

template <int Dim> PrescribedValues prescribed_values(const ContactSetup<Dim>& setup, double t) {
  PrescribedValues prescribed;
  prescribed.t = t;
  const auto nq = static_cast<std::size_t>(setup.model().num_coordinates());
  prescribed.value.resize(setup.model().num_coordinates());
  for (std::size_t tool = 0; tool < setup.tools().size(); ++tool) {
    const Prescription& prescription = setup.tools()[tool]->prescription();
    prescription.check_complete();
    for (int k = 0; k < prescription.size(); ++k) {
      const int at = setup.model().first[tool] + k;
      prescribed.is_motion.push_back(prescription.is_motion(k));
      prescribed.value[at] = prescription.value(k);
      if (!prescription.formula(k)) continue;
      if (prescription.is_motion(k)) {
        prescribed.value[at] = prescription.formula(k)->value(&t);
        continue;
      }
      prescribed.formula.resize(nq);
      prescribed.formula[static_cast<std::size_t>(at)] = prescription.formula(k);
    }
  }
  return prescribed;
}

template <int Dim> void check_not_placed(const ContactSetup<Dim>& setup, const ContactState<Dim>& state) {
  const Eigen::VectorXd placed = setup.placed();
  for (Eigen::Index at = 0; at < placed.size(); ++at) {
    if (placed[at] == state.q[at]) continue;
    std::ostringstream text;
    text << setup.model().coordinate(static_cast<int>(at)) << " was placed at " << placed[at]
         << " during the run, where it is " << state.q[at] << "; only move and force change it now";
    fail("contact.begin", text.str());
  }
}

template <int Dim>
void check_not_inside(const ContactSetup<Dim>& setup, const MeshLocator<Dim>& locator,
                      const ContactState<Dim>& state, const Eigen::VectorXd& u) {
  for (std::size_t t = 0; t < setup.tools().size(); ++t)
    if (within_body(setup, locator, state, static_cast<int>(t)))
      fail("contact.begin", "tool \"" + setup.tools()[t]->name() +
                                "\" lies within the workpiece, which has no node " +
                                "inside it; place the tool outside and call approach");
  const auto poses = setup.model().poses(state.q);
  const auto& body = setup.body();
  double deepest = -INSIDE * body.spacing;
  int node = -1, tool = -1;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const Vector<Dim> x = body.position(u, setup.candidates()[i]);
    const auto nearest = nearest_tool(setup.model(), poses, x, state.nodes[i], static_cast<int>(i));
    if (nearest.foot.gap >= deepest) continue;
    deepest = nearest.foot.gap;
    node = setup.candidates()[i];
    tool = nearest.tool;
  }
  if (node < 0) return;
  std::ostringstream text;
  text << "tool \"" << setup.tools()[tool]->name() << "\" starts inside the workpiece: node " << node
       << " at " << place_text(body.position(u, node)) << " penetrates by " << -deepest
       << "; place the tool outside and call approach, or, " << turned_to_the_body<Dim>();
  fail("contact.begin", text.str());
}

template <int Dim>
std::vector<std::string> check_support(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                                       const PrescribedValues& prescribed, bool first) {
  const auto& model = setup.model();
  std::vector<char> touches(model.tools.size(), 0), moves(model.tools.size(), 0);
  for (const auto& node : state.nodes)
    if (in_contact(node.state)) touches[node.tool] = 1;
  for (int k = 0; k < model.num_coordinates(); ++k)
    if (prescribed.is_motion[k] && prescribed.value[k] != state.q[k]) moves[model.tool_of(k)] = 1;
  const std::vector<int> idle = idle_coordinates(model, prescribed, state);
  std::vector<std::string> names;
  for (int k = 0; k < model.num_coordinates(); ++k) {
    const int tool = model.tool_of(k);
    const std::vector<int> followers = model.followers(k);
    if (touches[tool] || prescribed.is_motion[k] || prescribed.is_held(k) || model.coupling_of(k) ||
        std::any_of(followers.begin(), followers.end(), [&](int f) { return touches[model.tool_of(f)]; }))
      continue;
    const std::string name = coordinate(*setup.tools()[tool], k - model.first[tool]);
    if (std::find(idle.begin(), idle.end(), k) == idle.end() || (first && !moves[tool]))
      fail("contact.begin",
           name + " is under force but the tool touches nothing, so it has no support; bring the tool "
                  "into contact by motion or with approach first, or give the coordinate a motion");
    names.push_back(name);
  }
  return names;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template PrescribedValues prescribed_values<Dim>(const ContactSetup<Dim>&, double);                        \
  template void check_not_placed<Dim>(const ContactSetup<Dim>&, const ContactState<Dim>&);                   \
  template void check_not_inside<Dim>(const ContactSetup<Dim>&, const MeshLocator<Dim>&,                     \
                                      const ContactState<Dim>&, const Eigen::VectorXd&);                     \
  template std::vector<std::string> check_support<Dim>(const ContactSetup<Dim>&, const ContactState<Dim>&,   \
                                                       const PrescribedValues&, bool);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
