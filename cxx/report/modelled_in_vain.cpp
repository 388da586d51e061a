// Modelled and not needed.
#include "checks/known_law.hpp"
#include "contact/coupling.hpp"
#include "report/mirror.hpp"
#include "report/statements.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace burnish {
namespace {

using List = std::vector<Statement>;
constexpr StatementKind IN_VAIN = StatementKind::NOT_NEEDED;

template <int Dim> bool flowed(const Workpiece<Dim>& workpiece) {
  return known_law(workpiece) && plastic_strains(workpiece).maxCoeff() > 0;
}

template <int Dim> void say_of_yield(const ReportedRun<Dim>& run, List& list) {
  const double ratio = run.scene.stress_over_yield;
  if (!known_law(run.step.workpiece) || flowed(run.step.workpiece)) return;
  if (!(ratio > run.options.plausible_yield)) return; // meant to be elastic
  list.push_back({IN_VAIN, "yield", ratio, 35,
                  "nothing yielded, the von Mises stress reaches " + short_number(ratio) +
                      " of the yield stress: an elastic workpiece, sigY=1e30, gives the same"});
}

template <int Dim> void say_of_friction(const ReportedRun<Dim>& run, List& list) {
  for (int tool = 0; tool < static_cast<int>(run.scene.friction.size()); ++tool) {
    const FrictionUse& use = run.scene.friction[tool];
    const bool little = use.largest < run.options.friction_used, stuck = use.sliding == 0;
    if (use.nodes == 0 || !(little || stuck)) continue;
    const std::string name = run.step.tool_name(tool);
    list.push_back({IN_VAIN, "friction " + name, use.largest, little ? 41.0 : 40.0,
                    "friction of tool \"" + name + "\" never exceeds " + short_number(use.largest) +
                        " of its limit" + (stuck ? ", all nodes stick" : "") +
                        ": its coefficient is of no influence, sticking=true gives the same"});
  }
}

template <int Dim> void say_of_coordinates(const ReportedRun<Dim>& run, List& list) {
  const AcceptedStep<Dim>& step = run.step;
  const auto names = dotted_names(step.model);
  const auto poses = step.model.poses(step.contact.q);
  const double size = size_of(step.mesh);
  for (int k = 0; k < static_cast<int>(run.scene.coordinates.size()); ++k) {
    const CoordinateUse& use = run.scene.coordinates[k];
    if (!use.forced) continue;
    const int tool = step.model.tool_of(k), own = k - step.model.first[tool];
    const double per_unit = poses[tool].origin_q[own].norm() + size * poses[tool].R_q[own].norm();
    const double way = per_unit * (use.most - use.least) / size;
    if (!(way < run.options.unmoved)) continue;
    const double at = std::abs(use.most) < run.options.unmoved * size ? 0 : use.most; // no rounding
    const std::string dotted = names[k], coordinate = dotted.substr(dotted.rfind('.') + 1);
    list.push_back({IN_VAIN, "coordinate " + dotted, way, 45,
                    "coordinate \"" + coordinate + "\" of tool \"" + step.tool_name(tool) +
                        "\" is under force and never moved, by " + short_number(way) +
                        " of the size of the body: move(\"" + coordinate + "\", " + short_number(at) +
                        ") gives the same"});
  }
}

// The elements of least energy per volume, half of them.
template <int Dim> void say_of_energy(const ReportedRun<Dim>& run, List& list) {
  const std::vector<double>& energy = run.scene.energy;
  const Discretization<Dim>& space = run.step.workpiece.discretization();
  if (energy.size() < 2) return;
  std::vector<double> density = energy;
  for (std::size_t e = 0; e < density.size(); ++e) {
    const double* weight = space.weight.data() + e * space.points_per_element;
    density[e] /= std::accumulate(weight, weight + space.points_per_element, 0.0);
  }
  std::vector<int> order(energy.size());
  std::iota(order.begin(), order.end(), 0);
  const auto half = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  std::nth_element(order.begin(), half, order.end(), [&](int a, int b) { return density[a] < density[b]; });
  const auto sum = [&](auto from, auto to) {
    return std::accumulate(from, to, 0.0, [&](double s, int e) { return s + energy[e]; });
  };
  const double low = sum(order.begin(), half), all = low + sum(half, order.end());
  if (!(all > 0) || !(low < run.options.idle_energy * all)) return;
  list.push_back({IN_VAIN, "energy", low / all, 50,
                  "half of the mesh, " + std::to_string(half - order.begin()) + " of " +
                      std::to_string(order.size()) + " elements, holds " + short_number(low / all) +
                      " of the energy: a smaller body or a coarser mesh there gives the same"});
}

template <int Dim> void say_of_steps(const ReportedRun<Dim>& run, List& list) {
  const StepAccuracy& steps = run.accuracy;
  if (!(steps.error < run.options.fine_steps * steps.asked) || !steps.longest) return;
  list.push_back({IN_VAIN, "steps", steps.error / steps.asked, 60,
                  "the steps are finer than needed: their error is about " + short_number(steps.error) +
                      ", " + short_number(steps.asked) +
                      (steps.given ? " is asked for" : " passes without a warning") +
                      ": a larger dtmax= is enough"});
}

template <int Dim> void say_of_symmetry(const ReportedRun<Dim>& run, List& list) {
  for (int axis = 0; axis < static_cast<int>(run.scene.mirror.size()); ++axis) {
    const MirrorState& mirror = run.scene.mirror[axis];
    if (!mirror.possible || mirror.looks == 0) continue;
    const std::string name(1, "xyz"[axis]);
    list.push_back({IN_VAIN, "symmetry " + name, mirror.deviation, 55,
                    "the scene is symmetric about " + name + " = " +
                        short_number(middle_of(run.step.mesh, axis)) + ", to " +
                        short_number(mirror.deviation) +
                        " of the largest displacement: half of the mesh, held in " + name +
                        " there by fixed=, gives the same"});
  }
}

constexpr const char* UNITS =
    "; strains so small are right only if lengths, forces and stresses are in units of one system";

template <int Dim> void say_of_strains(const ReportedRun<Dim>& run, List& list) {
  const double gradient = run.scene.gradient;
  if (!(gradient <= run.options.small_strain) || !(gradient > 0)) return;
  const char* option = flowed(run.step.workpiece) ? ", and so does update=\"single\"" : "";
  list.push_back({IN_VAIN, "strain", gradient, 20,
                  "strains and rotations are at most " + short_number(gradient) +
                      " everywhere: the geometrically linear form gives the same" + option +
                      (gradient < run.options.no_strain ? UNITS : "")});
}

} // namespace

template <int Dim> std::vector<Statement> modelled_in_vain(const ReportedRun<Dim>& run) {
  List list;
  say_of_yield(run, list);
  say_of_friction(run, list);
  say_of_coordinates(run, list);
  say_of_energy(run, list);
  say_of_steps(run, list);
  say_of_symmetry(run, list);
  say_of_strains(run, list);
  return list;
}

template std::vector<Statement> modelled_in_vain<2>(const ReportedRun<2>&);
template std::vector<Statement> modelled_in_vain<3>(const ReportedRun<3>&);

} // namespace burnish
