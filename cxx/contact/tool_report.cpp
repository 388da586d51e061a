#include "contact/tool_report.hpp"
#include "base/error.hpp"
#include <set>

namespace burnish {
namespace {

/// Whether one of the names is that of another column of a history: time, forces, counts, maxima.
bool is_column(const std::vector<std::string>& names) {
  std::set<std::string> columns{
      "t",          "contact",       "contact_begin_deg",     "contact_end_deg", "sticking",
      "sliding",    "stress_eq_max", "plastic_strain_eq_max", "factorizations",  "support_Fx",
      "support_Fy", "support_Mz"};
  for (const std::string& name : names) columns.insert("Q_" + name);
  for (const std::string& name : names)
    if (columns.count(name)) return true;
  return false;
}

} // namespace

template <int Dim>
std::vector<std::string> coordinate_names(const std::vector<std::shared_ptr<const Tool<Dim>>>& tools) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const auto& tool : tools) {
    if (!seen.insert(tool->name()).second)
      fail("coordinate_names", "two tools bear the name \"" + tool->name() + "\", expected different names");
    const bool plain = tools.size() == 1 && !is_column(tool->coordinates().names());
    for (const std::string& name : tool->coordinates().names())
      names.push_back(plain ? name : tool->name() + "." + name);
  }
  return names;
}

template <int Dim>
long count_nodes(const ContactState<Dim>& state, const std::string& what, const char* where, int tool) {
  bool known = what == "contact";
  for (int k = 0; k <= static_cast<int>(NodeState::RECEDING); ++k)
    known = known || what == name_of(static_cast<NodeState>(k));
  if (!known)
    fail(where, "unknown state \"" + what +
                    "\", expected free, touched, sliding, sticking, leaving, receding or contact");
  long n = 0;
  for (const auto& node : state.nodes) {
    if (tool >= 0 && node.tool != tool) continue;
    n += what == "contact" ? in_contact(node.state) : what == name_of(node.state);
  }
  return n;
}

template <int Dim>
Vector<Dim> tool_resultant(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                           const Eigen::VectorXd& R, int tool) {
  Vector<Dim> sum = Vector<Dim>::Zero();
  std::vector<Pose<Dim>> poses;
  if (!model.constrained.empty()) poses = model.poses(state.q);
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    if (node.tool != tool || !in_contact(node.state)) continue;
    Vector<Dim> F = R.template segment<Dim>(Dim * model.candidates[i]);
    if (model.is_constrained(i)) F = nodal_force(model, i, contact_point(model, poses, node).surface, F).F;
    sum -= F;
  }
  return sum;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template std::vector<std::string> coordinate_names<Dim>(                                                   \
      const std::vector<std::shared_ptr<const Tool<Dim>>>&);                                                 \
  template long count_nodes<Dim>(const ContactState<Dim>&, const std::string&, const char*, int);            \
  template Vector<Dim> tool_resultant<Dim>(const ContactModel<Dim>&, const ContactState<Dim>&,               \
                                           const Eigen::VectorXd&, int);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
