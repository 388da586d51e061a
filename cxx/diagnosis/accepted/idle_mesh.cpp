// Half of the mesh that holds next to no energy (ALGORITHMS.md 17.1).
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/stress_algebra.hpp"
#include <algorithm>
#include <numeric>

namespace burnish {
namespace {

constexpr double IDLE = 1e-3; // energy of half of the mesh over that of all of it

template <int Dim> class IdleMesh final : public ObserverOf<IdleMesh<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_energy)
  void look(const AcceptedStep<Dim>& step, FindingList&) override;
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override;

private:
  std::vector<double> m_energy; // per element: stored and dissipated, the largest
};

template <int Dim> void IdleMesh<Dim>::look(const AcceptedStep<Dim>& step, FindingList&) {
  const MaterialLaw<Dim>* law = known_law(step.workpiece);
  if (!law || !step.first_of_ten()) return;
  const Workpiece<Dim>& body = *step.workpiece;
  const Discretization<Dim>& space = body.discretization();
  const auto moduli = law->moduli();
  const double G = moduli.at("G"), K = moduli.at("K"), yield = law->yield_stress(0).value;
  const auto flow = plastic_strains(body);
  m_energy.resize(space.num_elements);
  for (int e = 0; e < space.num_elements; ++e) {
    double energy = 0;
    for (int p = e * space.points_per_element; p < (e + 1) * space.points_per_element; ++p) {
      const Stress<Dim> tau = point_state(body.state_old(), p).stress, s = deviator<Dim>(tau);
      const double m = mean<Dim>(tau);
      double density = contract<Dim>(s, s) / (4 * G) + m * m / (2 * K);
      if (flow[p] > 0 && yield > 0) density += 0.5 * flow[p] * (yield + law->yield_stress(flow[p]).value);
      energy += space.weight[p] * density;
    }
    m_energy[e] = std::max(m_energy[e], energy);
  }
}

// The elements of least energy per volume, half of them.
template <int Dim> void IdleMesh<Dim>::end(const EndedRun<Dim>& run, std::vector<Statement>& list) const {
  if (m_energy.size() < 2) return;
  const Discretization<Dim>& space = run.step.workpiece->discretization();
  std::vector<double> density = m_energy;
  for (std::size_t e = 0; e < density.size(); ++e) {
    const double* weight = space.weight.data() + e * space.points_per_element;
    density[e] /= std::accumulate(weight, weight + space.points_per_element, 0.0);
  }
  std::vector<int> order(m_energy.size());
  std::iota(order.begin(), order.end(), 0);
  const auto half = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  std::nth_element(order.begin(), half, order.end(), [&](int a, int b) { return density[a] < density[b]; });
  const auto sum = [&](auto from, auto to) {
    return std::accumulate(from, to, 0.0, [&](double s, int e) { return s + m_energy[e]; });
  };
  const double low = sum(order.begin(), half), all = low + sum(half, order.end());
  if (!(all > 0) || !(low < IDLE * all)) return;
  list.push_back({StatementKind::NOT_NEEDED, "energy", low / all, 50,
                  "half of the mesh, " + std::to_string(half - order.begin()) + " of " +
                      std::to_string(order.size()) + " elements, holds " + short_number(low / all) +
                      " of the energy: a smaller body or a coarser mesh there gives the same"});
}

} // namespace

BURNISH_OBSERVER(idle_mesh, IdleMesh)

} // namespace burnish
