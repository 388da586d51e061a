// Volume that plastic flow has changed (ALGORITHMS.md 16.5).
#include "base/sentence.hpp"
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/stress_algebra.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr Bounds VOLUME{0.02}; // change that is not elastic over the plastic strain

template <int Dim> class VolumeCheck final : public ObserverOf<VolumeCheck<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;
};

template <int Dim> void VolumeCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  if (!step.workpiece || step.workpiece->user_defined() || !step.tenth()) return;
  const MaterialLaw<Dim>* law = known_law(step.workpiece);
  if (!law || step.workpiece->state().tracks_integrity()) return; // healing sets stress and strain anew
  const double K = law->moduli().at("K");
  const Discretization<Dim>& space = step.workpiece->discretization();
  const auto strains = plastic_strains(*step.workpiece);
  double change = 0, flow = 0;
  for (int p = 0; p < space.num_points(); ++p) {
    const double strain = strains[p];
    if (!(strain > 0)) continue;
    const PointState<Dim> point = point_state(step.workpiece->state_old(), p);
    const double excess = volume_strain<Dim>(point.F, law->small_strain()) - mean<Dim>(point.stress) / K;
    change += space.weight[p] * std::abs(excess);
    flow += space.weight[p] * strain;
  }
  if (!(flow > 0)) return;
  findings.largest("volume", change / flow);
  Finding* finding = findings.beyond("volume", "", change / flow, VOLUME, step.t);
  if (!finding) return;
  finding->text = sentence("plastic flow changes the volume, by ", change / flow,
                           " of the plastic strain, t = ", step.t, ": shorter steps keep it");
}

} // namespace

BURNISH_OBSERVER(volume_check, VolumeCheck)

} // namespace burnish
