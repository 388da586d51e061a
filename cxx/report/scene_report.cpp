#include "report/scene_report.hpp"
#include "base/cpu_time.hpp"
#include "checks/known_law.hpp"
#include "material/stress_algebra.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace burnish {

template <int Dim> void SceneReport<Dim>::look(const AcceptedStep<Dim>& step) {
  const CpuTimer timer(m_seconds);
  if (!m_begun) find_ends(step);
  ++m_state.steps;
  look_at_tools(step);
  look_at_coordinates(step);
  m_state.window = std::max(m_state.window, step.window);
  if ((m_state.steps - 1) % m_options.seldom != 0 && !step.last) return;
  double load = 0;
  for (const auto& node : step.touching) load += node.force.F.norm();
  look_at_points(step, load);
  if (!step.touching.empty()) look_at_symmetry(step);
}

// In the plane; the surface of a body in space has no last node.
template <int Dim> void SceneReport<Dim>::find_ends(const AcceptedStep<Dim>& step) {
  m_begun = true;
  m_size = size_of(step.mesh);
  for (int axis = 0; axis < Dim; ++axis) m_middle[axis] = middle_of(step.mesh, axis);
  m_end.assign(step.model.candidates.size(), 0);
  if (Dim != 2) return;
  std::map<int, int> facets;
  for (const auto& facet : step.surface)
    for (const int node : facet.vertex) ++facets[node];
  for (std::size_t i = 0; i < m_end.size(); ++i) {
    const int node = step.model.candidates[i];
    const auto found = facets.find(node);
    bool held = false;
    for (int c = 0; c < Dim; ++c) held = held || step.body.fixed[static_cast<std::size_t>(Dim * node + c)];
    m_end[i] = found != facets.end() && found->second == 1 && !held;
  }
}

template <int Dim> void SceneReport<Dim>::look_at_tools(const AcceptedStep<Dim>& step) {
  m_state.friction.resize(step.model.tools.size());
  m_state.ends.resize(step.model.tools.size());
  for (int tool = 0; tool < static_cast<int>(step.model.tools.size()); ++tool) {
    double load = 0, largest = 0;
    for (const auto& node : step.touching) {
      if (step.contact.nodes[node.candidate].tool != tool) continue;
      load += node.force.F.norm();
      largest = std::max(largest, node.force.part.N);
    }
    if (!(load > step.tolerance * step.load)) continue;
    look_at_friction(step, tool, largest);
    look_at_ends(step, tool, load);
  }
}

template <int Dim>
void SceneReport<Dim>::look_at_friction(const AcceptedStep<Dim>& step, int tool, double largest) {
  FrictionUse& use = m_state.friction[tool];
  for (const auto& node : step.touching) {
    const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
    if (contact.tool != tool || contact.tied || !(node.force.part.N > m_options.loaded * largest)) continue;
    const TangentialLaw<Dim>& law = step.model.law(node.candidate, tool);
    if (law.frictionless() || law.friction().sticks_always()) continue;
    const double limit = law.capacity(node.deciding.force.N, node.deciding.area);
    if (!(limit > 0)) continue;
    ++use.nodes;
    use.sliding += contact.state == NodeState::SLIDING;
    use.largest = std::max(use.largest, node.deciding.force.T.norm() / limit);
  }
}

template <int Dim> void SceneReport<Dim>::look_at_ends(const AcceptedStep<Dim>& step, int tool, double load) {
  EndLoad& end = m_state.ends[tool];
  end.load = std::max(end.load, load);
  std::size_t nodes = 0;
  for (const auto& node : step.touching) nodes += step.contact.nodes[node.candidate].tool == tool;
  if (static_cast<double>(nodes) >= m_options.all_under * static_cast<double>(step.contact.nodes.size()))
    return;
  for (const auto& node : step.touching) {
    if (step.contact.nodes[node.candidate].tool != tool || !m_end[node.candidate]) continue;
    const double force = node.force.F.norm();
    if (!(force > end.force)) continue;
    end.force = force;
    end.place = step.place_of(node.x);
    end.t = step.t;
  }
}

template <int Dim> void SceneReport<Dim>::look_at_coordinates(const AcceptedStep<Dim>& step) {
  const Eigen::VectorXd& q = step.contact.q;
  if (m_state.coordinates.empty())
    for (const double value : q) m_state.coordinates.push_back({true, value, value});
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    CoordinateUse& use = m_state.coordinates[k];
    use.least = std::min(use.least, q[k]);
    use.most = std::max(use.most, q[k]);
    use.forced = use.forced && step.prescribed && !step.prescribed->is_motion[k] &&
                 !step.model.coupling_of(static_cast<int>(k));
  }
}

template <int Dim> void SceneReport<Dim>::look_at_points(const AcceptedStep<Dim>& step, double load) {
  const Workpiece<Dim>& body = step.workpiece;
  const Discretization<Dim>& space = body.discretization();
  const MaterialLaw<Dim>* law = known_law(body);
  const auto moduli = law ? law->moduli() : std::map<std::string, double>();
  const double G = law ? moduli.at("G") : 0, K = law ? moduli.at("K") : 0;
  const double yield = law ? law->yield_stress(0).value : 0;
  const Gradient<Dim> I = undeformed<Dim>();
  const Eigen::VectorXd flow = law ? Eigen::VectorXd(plastic_strains(body)) : Eigen::VectorXd();
  double gradient = 0, squared = 0;
  if (law) m_state.energy.resize(space.num_elements);
  for (int e = 0; e < space.num_elements; ++e) {
    double energy = 0;
    for (int p = e * space.points_per_element; p < (e + 1) * space.points_per_element; ++p) {
      const PointState<Dim> point = body.point_old(p);
      gradient = std::max(gradient, (point.F - I).squaredNorm());
      if (!law) continue;
      const Stress<Dim> tau = point.stress, s = deviator<Dim>(tau);
      const double ss = contract<Dim>(s, s), m = mean<Dim>(tau);
      squared = std::max(squared, 1.5 * ss);
      double density = ss / (4 * G) + m * m / (2 * K);
      if (flow[p] > 0 && yield > 0) density += 0.5 * flow[p] * (yield + law->yield_stress(flow[p]).value);
      energy += space.weight[p] * density;
    }
    if (law) m_state.energy[e] = std::max(m_state.energy[e], energy);
  }
  m_state.gradient = std::max(m_state.gradient, std::sqrt(gradient));
  if (yield > 0) m_state.stress_over_yield = std::max(m_state.stress_over_yield, std::sqrt(squared) / yield);
  if (load > 0 && load >= m_state.load) {
    m_state.load = load;
    m_state.load_t = step.t;
    m_state.stress = body.state_old().stress;
  }
}

template <int Dim> bool SceneReport<Dim>::touches_both_halves(const AcceptedStep<Dim>& step, int axis) {
  constexpr double on_it = 1e-6; // nodes on the middle belong to both
  bool low = false, high = false;
  for (const auto& node : step.touching) {
    const double x = step.mesh.node(step.model.candidates[node.candidate])[axis] - m_middle[axis];
    low = low || x <= on_it * m_size;
    high = high || x >= -on_it * m_size;
  }
  return low && high;
}

// An axis that is none in one step is looked at no more; most are none in the first.
template <int Dim> void SceneReport<Dim>::look_at_symmetry(const AcceptedStep<Dim>& step) {
  m_state.mirror.resize(Dim);
  m_mirror.resize(Dim);
  for (int axis = 0; axis < Dim; ++axis) {
    MirrorState& state = m_state.mirror[axis];
    if (axis == 0 && step.mesh.axisymmetric) state.possible = false;
    if (!state.possible) continue;
    state.possible = touches_both_halves(step, axis);
    if (!state.possible) continue;
    if (!m_locator) m_locator = std::make_unique<MeshLocator<Dim>>(step.mesh);
    if (!m_mirror[axis]) m_mirror[axis] = std::make_unique<Mirror<Dim>>(step.mesh, *m_locator, axis);
    state.possible = m_mirror[axis]->possible();
    if (!state.possible) continue;
    ++state.looks;
    state.deviation = std::max(state.deviation, m_mirror[axis]->deviation(step.u));
    state.possible = state.deviation <= m_options.asymmetry;
  }
}

template class SceneReport<2>;
template class SceneReport<3>;

} // namespace burnish
