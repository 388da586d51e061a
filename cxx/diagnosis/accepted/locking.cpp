// Linear elements that lock: the mean stress alternates from element to element (ALGORITHMS.md 16.6).
#include "base/sentence.hpp"
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/stress_algebra.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace burnish {
namespace {

constexpr Bounds LOCKING{1, 20}; // alternation of the mean stress over the von Mises stress

template <int Dim> class LockingCheck final : public ObserverOf<LockingCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_neighbor)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  void find_neighbors(const Mesh<Dim>& mesh);
  // Jumps of the mean stress over the von Mises stress, of plastic elements or of all; 0 where none can tell [-].
  double alternation(const AcceptedStep<Dim>& step, bool everywhere) const;
  std::vector<int> m_neighbor; // per element and vertex: across the opposite face, -1: none
};

template <int Dim> void LockingCheck<Dim>::find_neighbors(const Mesh<Dim>& mesh) {
  std::map<std::array<int, Dim>, int> first;
  m_neighbor.assign(static_cast<std::size_t>(mesh.num_elements) * (Dim + 1), -1);
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int v = 0; v <= Dim; ++v) {
      std::array<int, Dim> face;
      for (int w = 0, k = 0; w <= Dim; ++w)
        if (w != v) face[k++] = mesh.element(e)[w];
      std::sort(face.begin(), face.end());
      const int slot = e * (Dim + 1) + v;
      const auto [entry, fresh] = first.emplace(face, slot);
      if (fresh) continue;
      m_neighbor[slot] = entry->second / (Dim + 1);
      m_neighbor[entry->second] = e;
    }
}

template <int Dim>
double LockingCheck<Dim>::alternation(const AcceptedStep<Dim>& step, bool everywhere) const {
  const WorkpieceState<Dim>& body = step.workpiece->state_old();
  const Discretization<Dim>& space = step.workpiece->discretization();
  double jumps = 0, shear = 0;
  for (int e = 0; e < step.mesh().num_elements; ++e) {
    if (!everywhere && !body.plastic[e]) continue;
    const Stress<Dim> tau = point_state(step.workpiece->state_old(), e).stress, s = deviator<Dim>(tau);
    double around = 0, number = 0;
    for (int v = 0; v <= Dim; ++v) {
      const int other = m_neighbor[e * (Dim + 1) + v];
      if (other < 0 || !(everywhere || body.plastic[other])) continue;
      around += mean<Dim>(Stress<Dim>(point_state(step.workpiece->state_old(), other).stress));
      ++number;
    }
    if (number < Dim) continue;
    const double jump = mean<Dim>(tau) - around / number;
    jumps += space.weight[e] * jump * jump;
    shear += space.weight[e] * squared_equivalent<Dim>(s);
  }
  return shear > 0 ? std::sqrt(jumps / shear) : 0;
}

template <int Dim> void LockingCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  constexpr double nearly_incompressible = 10; // K over G, nu = 0.45
  if (step.mesh().nodes_per_element != Dim + 1) return;
  if (!step.tenth()) return;
  const MaterialLaw<Dim>* law = known_law(step.workpiece);
  if (!law) return;
  if (m_neighbor.empty()) find_neighbors(step.mesh());
  const auto moduli = law->moduli();
  const double value = alternation(step, moduli.at("K") > nearly_incompressible * moduli.at("G"));
  if (!(value > 0)) return;
  findings.largest("locking", value);
  Finding* finding = findings.beyond("locking", "", value, LOCKING, step.t);
  if (!finding) return;
  finding->text = sentence("P1 locks here: the mean stress alternates from element to element, by ", value,
                           " of the von Mises stress, t = ", step.t, ": take P2");
}

} // namespace

BURNISH_OBSERVER(locking_check, LockingCheck)

} // namespace burnish
