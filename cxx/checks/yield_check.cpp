#include "checks/yield_check.hpp"
#include "checks/known_law.hpp"
#include "material/stress_algebra.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace burnish {

template <int Dim>
void YieldCheck<Dim>::look_at_volume(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                     CheckState& state, FindingList& findings) const {
  const MaterialLaw<Dim>* law = known_law(step.workpiece);
  if (!law || step.workpiece.tracks_integrity()) return; // healing sets stress and strain anew
  const double K = law->moduli().at("K");
  const Discretization<Dim>& space = step.workpiece.discretization();
  const auto strains = plastic_strains(step.workpiece);
  double change = 0, flow = 0;
  for (int p = 0; p < space.num_points(); ++p) {
    const double strain = strains[p];
    if (!(strain > 0)) continue;
    const PointState<Dim> point = step.workpiece.point_old(p);
    const double excess = std::log(determinant(Gradient<Dim>(point.F))) - mean<Dim>(point.stress) / K;
    change += space.weight[p] * std::abs(excess);
    flow += space.weight[p] * strain;
  }
  if (!(flow > 0)) return;
  state.largest("volume", change / flow);
  if (!(change > options.volume * flow)) return;
  Finding* finding = findings.report("volume", "", Severity::WARNING, change / flow, step.t);
  if (!finding) return;
  finding->value = change / flow;
  finding->bound = options.volume;
  std::ostringstream text;
  text << "plastic flow changes the volume, by " << change / flow << " of the plastic strain, t = " << step.t
       << ": shorter steps keep it";
  finding->text = text.str();
}

template <int Dim>
void YieldCheck<Dim>::look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                           FindingList& findings) {
  if (step.workpiece.user_defined() || (state.steps % options.seldom != 0 && !step.last)) return;
  double worst = -1;
  int at = -1;
  const std::vector<char>& plastic = step.workpiece.state_old().plastic;
  for (int p = 0; p < static_cast<int>(plastic.size()); ++p) {
    if (!plastic[p]) continue;
    const double distance = step.workpiece.yield_distance(p);
    if (distance <= worst) continue;
    worst = distance;
    at = p;
  }
  look_at_volume(step, options, state, findings);
  if (at < 0) return;
  state.largest("yield", worst);
  if (!(worst > options.yield_distance)) return;
  const bool far = worst > options.yield_far;
  Finding* finding =
      findings.report("yield", "", far ? Severity::UNTRUSTED : Severity::WARNING, worst, step.t);
  if (!finding) return;
  finding->value = worst;
  finding->bound = far ? options.yield_far : options.yield_distance;
  const Vector<Dim> x = step.point(at);
  finding->place = step.place_of(x);
  std::ostringstream text;
  text << "stress lies outside the yield surface by " << worst << " of the yield stress" << step.at(x);
  finding->text = text.str();
}

template class YieldCheck<2>;
template class YieldCheck<3>;

} // namespace burnish
